#include "engine/remeshed/ghosts/reentrant_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::remeshed {

namespace {

constexpr double alike = 0.9;      // cosine between normals of a smooth surface in adjacent cells
constexpr double different = 0.7;  // cosine between the normals of two faces
constexpr double least_height = 0.4;  // [h] of one face's foot point above the other face
constexpr double farthest = 1.1;      // [h] of nodes from the surface; beyond, even smooth faces meet

/// A place of the surface near a node.
template <int D>
struct Facet {
  Point<D> foot;    ///< relative to the node [h]
  Point<D> normal;  ///< unit, out of the body

  double height_of_node() const { return -dot<D>(foot, normal); }
};

/// The surface as the free-surface nodes in the cells around a slot see it; nothing if it is smooth
/// there.
template <class T, int D>
class FacetsAround {
 public:
  FacetsAround(const Population<T, D>& population, const LevelSet<T, D>& level_set, double spacing)
      : population_(population), level_set_(level_set), spacing_(spacing) {}

  std::span<const Facet<D>> find(const kernels::Segment<D>& segment, std::int64_t slot,
                                 const Cell<D>& cell) {
    constexpr int depth = D == 3 ? 1 : 0;
    count_ = 0;
    const std::optional<Facet<D>> own = facet(slot, cell, {});
    if (!own) return {};
    bool is_smooth = true;
    for (int dz = -depth; dz <= depth; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        const std::int64_t row = slot + segment.neighbour_row[kernels::row_index<D>(dy, dz)];
        for (int dx = -1; dx <= 1; ++dx) {
          Cell<D> away = {};
          away[0] = dx;
          away[1] = dy;
          if constexpr (D == 3) away[2] = dz;
          const std::optional<Facet<D>> other = facet(row + dx, cell, away);
          if (!other) continue;
          const bool turns = dot<D>(other->normal, own->normal) < alike;
          if (turns && !is_at(row + dx, cell, away)) continue;
          is_smooth = is_smooth && !turns;
          facets_[count_++] = *other;
        }
      }
    }
    return {facets_.data(), is_smooth ? 0 : count_};
  }

 private:
  // The offset to a row that does not exist may lead anywhere.
  bool is_at(std::int64_t slot, const Cell<D>& cell, const Cell<D>& away) const {
    return population_.layout.slot(moved(cell, away)) == slot;
  }

  static Cell<D> moved(Cell<D> cell, const Cell<D>& away) {
    for (int a = 0; a < D; ++a) cell[a] += away[a];
    return cell;
  }

  std::optional<Facet<D>> facet(std::int64_t slot, const Cell<D>& cell, const Cell<D>& away) const {
    Point<D> offset;
    if (population_.kind[slot] != Kind::free_ghost || !level_set_.closest_point(slot, offset)) {
      return std::nullopt;
    }
    if (norm<D>(offset) > farthest * spacing_) return std::nullopt;
    Facet<D> result{as_point<D>(away), level_set_.outward(moved(cell, away), offset)};
    for (int a = 0; a < D; ++a) result.foot[a] += offset[a] / spacing_;
    return result;
  }

  const Population<T, D>& population_;
  const LevelSet<T, D>& level_set_;
  double spacing_;
  std::array<Facet<D>, D == 2 ? 9 : 27> facets_;
  std::size_t count_ = 0;
};

/// Whether each of two facets lies in front of the other.
template <int D>
bool face_each_other(const Facet<D>& a, const Facet<D>& b) {
  const Point<D> apart = difference<D>(b.foot, a.foot);
  return dot<D>(apart, a.normal) > least_height && -dot<D>(apart, b.normal) > least_height;
}

/// The pair of facets that face each other whose normals differ most.
template <int D>
std::optional<std::array<Facet<D>, 2>> faces_among(std::span<const Facet<D>> facets) {
  std::optional<std::array<Facet<D>, 2>> faces;
  double least = different;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double cosine = dot<D>(facets[i].normal, facets[j].normal);
      if (cosine >= least || cosine < -different) continue;
      if (!face_each_other(facets[i], facets[j])) continue;
      least = cosine;
      faces = {facets[j], facets[i]};
    }
  }
  return faces;
}

/// The place nearest to the node at x where the planes of two facets meet.
template <int D>
Point<D> corner_of(const std::array<Facet<D>, 2>& faces, Point<D> x, double spacing) {
  const auto& [first, second] = faces;
  const double cosine = dot<D>(first.normal, second.normal);
  const double one = first.height_of_node(), two = second.height_of_node();
  const double along_first = (one - cosine * two) / (1 - cosine * cosine);
  const double along_second = (two - cosine * one) / (1 - cosine * cosine);
  for (int a = 0; a < D; ++a) {
    x[a] -= spacing * (along_first * first.normal[a] + along_second * second.normal[a]);
  }
  return x;
}

}  // namespace

template <class T, int D>
void find_reentrant_corners(const Lattice<D>& lattice, const Population<T, D>& population,
                            const LevelSet<T, D>& level_set, int block,
                            std::vector<Point<D>>& corners) {
  corners.clear();
  FacetsAround<T, D> around(population, level_set, lattice.spacing);
  const Layout<D>& layout = population.layout;
  const Block<D>& range = layout.blocks()[block];
  for (const kernels::Segment<D>& segment :
       std::span(layout.segments_of(range), range.segment_count)) {
    Cell<D> cell = segment.cell;
    const std::int64_t end = segment.first + segment.count;
    for (std::int64_t slot = segment.first; slot < end; ++slot, ++cell[0]) {
      if (population.kind[slot] != Kind::free_ghost) continue;
      const auto faces = faces_among<D>(around.find(segment, slot, cell));
      if (faces) corners.push_back(corner_of<D>(*faces, lattice.node(cell), lattice.spacing));
    }
  }
}

template <int D>
void ReentrantCorners<D>::collect(const std::vector<std::vector<Point<D>>>& blocks, double reach) {
  count_ = 0;
  reach_ = reach;
  Point<D> lower = {}, upper = {};
  for (const std::vector<Point<D>>& corners : blocks) {
    for (const Point<D>& corner : corners) {
      for (int a = 0; a < D; ++a) {
        lower[a] = count_ == 0 ? corner[a] : std::min(lower[a], corner[a]);
        upper[a] = count_ == 0 ? corner[a] : std::max(upper[a], corner[a]);
      }
      ++count_;
    }
  }
  if (count_ == 0) return;
  cells_.cover(lower, upper, {}, reach, count_);
  cells_.sort(count_, [&](auto&& add) {
    for (const std::vector<Point<D>>& corners : blocks) {
      for (const Point<D>& corner : corners) add(Site<double, D>{corner, 0});
    }
  });
}

template <int D>
double ReentrantCorners<D>::distance(const Point<D>& x) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double nearest = infinity;
  if (count_ == 0) return nearest;
  cells_.any_near(x, [&](const Site<double, D>& corner, const Point<D>&) {
    nearest = std::min(nearest, norm<D>(difference<D>(x, corner.position)));
    return false;
  });
  return nearest <= reach_ ? nearest : infinity;
}

template class ReentrantCorners<2>;
template class ReentrantCorners<3>;
template void find_reentrant_corners<double, 2>(const Lattice<2>&, const Population<double, 2>&,
                                                const LevelSet<double, 2>&, int,
                                                std::vector<Point<2>>&);
template void find_reentrant_corners<double, 3>(const Lattice<3>&, const Population<double, 3>&,
                                                const LevelSet<double, 3>&, int,
                                                std::vector<Point<3>>&);
template void find_reentrant_corners<float, 2>(const Lattice<2>&, const Population<float, 2>&,
                                               const LevelSet<float, 2>&, int,
                                               std::vector<Point<2>>&);
template void find_reentrant_corners<float, 3>(const Lattice<3>&, const Population<float, 3>&,
                                               const LevelSet<float, 3>&, int,
                                               std::vector<Point<3>>&);

}  // namespace pliant::remeshed
