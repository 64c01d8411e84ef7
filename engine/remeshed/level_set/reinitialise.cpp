#include <cmath>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/level_set/level_set.hpp"

// Reinitialisation of the nodes near the surface. The zero set of the cubic interpolant bulges next
// to edges of the body. Distances to it would let the body grow there each time.
namespace pliant::remeshed {

namespace {

// Constants of (RP.82).
constexpr double seen_from_edge = 2;   // [cells] between closest points near an edge
constexpr double edge_cosine = 0.7;    // of the angle between their normals
constexpr double least_offset = 0.05;  // [cells] needed for a normal

}  // namespace

template <class T, int D>
void LevelSet<T, D>::take_distances(const Block<D>& block) {
  for (int s = block.first_segment; s < block.first_segment + block.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout_->segments()[s];
    Cell<D> cell = segment.cell;
    for (std::int64_t p = segment.first; p < segment.first + segment.count; ++p, ++cell[0]) {
      if (layer_[0][p] != found) continue;
      double square = 0;
      for (int a = 0; a < D; ++a) square += double(foot_[a][p]) * foot_[a][p];
      if (square > trusted * trusted || lies_near_edge(segment, p, cell)) continue;
      phi_[p] = std::copysign(static_cast<T>(std::sqrt(square) * lattice_->spacing), extended_[p]);
    }
  }
}

// (RP.82): whether the normal at a closest point near that of the node is very different.
template <class T, int D>
bool LevelSet<T, D>::lies_near_edge(const kernels::Segment<D>& segment, std::int64_t slot,
                                    const Cell<D>& cell) const {
  constexpr int reach = 2;
  const auto offset_of = [this](std::int64_t p) {
    Point<D> offset;
    for (int a = 0; a < D; ++a) offset[a] = foot_[a][p];
    return offset;
  };
  const Point<D> own = offset_of(slot);
  const double square = dot<D>(own, own);
  if (square < least_offset * least_offset) return false;
  const bool periodic = lattice_->is_periodic();
  const int depth = D == 3 ? reach : 0;
  for (int k = -depth; k <= depth; ++k) {
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) {
        Cell<D> step = {i, j}, other = cell;
        if constexpr (D == 3) step[2] = k;
        for (int a = 0; a < D; ++a) other[a] += step[a];
        std::int64_t q = slot + segment.neighbour_row[kernels::row_index<D>(j, k)] + i;
        if (periodic) q = layout_->slot(lattice_->wrapped(other));
        if (q < 0 || layer_[0][q] == 0) continue;
        const Point<D> offset = offset_of(q);
        const double length = dot<D>(offset, offset);
        Point<D> between = difference<D>(offset, own);
        for (int a = 0; a < D; ++a) between[a] += step[a];
        if (length < least_offset * least_offset ||
            dot<D>(between, between) > seen_from_edge * seen_from_edge) {
          continue;
        }
        const double sign = (extended_[q] < 0) == (extended_[slot] < 0) ? 1 : -1;
        if (sign * dot<D>(offset, own) > edge_cosine * std::sqrt(length * square)) continue;
        if (periodic || layout_->slot(other) == q) return true;
      }
    }
  }
  return false;
}

template void LevelSet<double, 2>::take_distances(const Block<2>&);
template void LevelSet<double, 3>::take_distances(const Block<3>&);
template void LevelSet<float, 2>::take_distances(const Block<2>&);
template void LevelSet<float, 3>::take_distances(const Block<3>&);
template bool LevelSet<double, 2>::lies_near_edge(const kernels::Segment<2>&, std::int64_t,
                                                  const Cell<2>&) const;
template bool LevelSet<double, 3>::lies_near_edge(const kernels::Segment<3>&, std::int64_t,
                                                  const Cell<3>&) const;
template bool LevelSet<float, 2>::lies_near_edge(const kernels::Segment<2>&, std::int64_t,
                                                 const Cell<2>&) const;
template bool LevelSet<float, 3>::lies_near_edge(const kernels::Segment<3>&, std::int64_t,
                                                 const Cell<3>&) const;

}  // namespace pliant::remeshed
