#include "engine/point_based/surface/surface_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/column.hpp"
#include "engine/lattice/mean_phi.hpp"
#include "engine/point_based/nodes/body_lattice.hpp"
#include "engine/undeformed/contact/surface_place.hpp"

namespace pliant::point_based {

namespace {

constexpr double on_shape = 1e-9;  // [h]
constexpr double at_point = 1e-6;  // relative to the way to the next lattice point
constexpr double touching = 1e-6;  // of boxes and cells [h]

// A crossing at a lattice point is that point. A piece with two equal corners has no area.
template <class Piece>
bool has_twins(const Piece& piece) {
  for (std::size_t v = 0; v < piece.size(); ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      if (piece[v].name == piece[w].name) return true;
    }
  }
  return false;
}

}  // namespace

template <int D>
SurfaceLattice<D>::SurfaceLattice(const Shape& shape, double spacing)
    : spacing_(spacing), pitch_(lattice_pitch<D>(shape, spacing)) {
  const Box<3> box = bounding_box(shape);
  std::int64_t count = 1;
  Cell<D> last;
  for (int a = 0; a < D; ++a) {
    const double cells = std::round((box.upper[a] - box.lower[a]) / pitch_[a]);
    lower_[a] = box.lower[a] - pitch_[a];
    extent_[a] = static_cast<std::int32_t>(cells) + 3;
    last[a] = extent_[a] - 1;
    count *= extent_[a];
  }
  phi_.reserve(count);
  DistanceWalk distance(shape, D, 2 * spacing_);
  for_each_cell<D>({}, last, [&](const Cell<D>& cell) {
    const double phi = distance(padded<D>(place(cell))) / spacing_;
    phi_.push_back(std::abs(phi) < on_shape ? -on_shape : phi);
  });
  if (contains_mesh(shape))
    phi_ = mean_phi<D>(phi_, extent_);
  else
    shape_ = &shape;
}

template <int D>
Point<D> SurfaceLattice<D>::place(const Cell<D>& cell) const {
  Point<D> x;
  for (int a = 0; a < D; ++a) x[a] = lower_[a] + cell[a] * pitch_[a];
  return x;
}

template <int D>
std::int64_t SurfaceLattice<D>::slot(const Cell<D>& cell) const {
  std::int64_t slot = 0;
  for (int a = D - 1; a >= 0; --a) slot = slot * extent_[a] + cell[a];
  return slot;
}

template <int D>
auto SurfaceLattice<D>::cube_at(const Cell<D>& cell) const -> std::pair<Cube, int> {
  Cube cube;
  int inside = 0;
  for (int c = 0; c < (1 << D); ++c) {
    SurfaceNode<D>& node = cube[c];
    node.cell = cell;
    for (int a = 0; a < D; ++a) node.cell[a] += c >> a & 1;
    node.slot = slot(node.cell);
    node.phi = phi_[node.slot];
    inside += node.phi < 0 ? 1 : 0;
    const Point<D> x = place(node.cell);
    for (int a = 0; a < D; ++a) node.place[a] = x[a];
  }
  return {cube, inside};
}

// At a point on the surface, all lines from it end in the same corner, except those that run along
// a face of the body up to its edge.
template <int D>
auto SurfaceLattice<D>::corner(const Crossing<D>& crossing) const -> Corner {
  const SurfaceNode<D>&inside = *crossing.inside, &outside = *crossing.outside;
  double way = &inside == &outside ? 0 : crossing.fraction();
  if (&inside != &outside && way < at_point && shape_ != nullptr) {
    way = undeformed::way_along_face<D>(*shape_, as_point<D>(inside.place),
                                        as_point<D>(outside.place), spacing_);
  }
  const PlaceVector<D> at = inside.place + way * (outside.place - inside.place);
  return {{inside.slot, (way < at_point ? inside : outside).slot}, as_point<D>(at)};
}

template <int D>
auto SurfaceLattice<D>::facets() const -> std::vector<Facet> {
  std::vector<Facet> facets;
  Cell<D> last;
  for (int a = 0; a < D; ++a) last[a] = extent_[a] - 2;
  for_each_cell<D>({}, last, [&](const Cell<D>& cell) {
    const auto [cube, inside] = cube_at(cell);
    if (inside == 0 || inside == (1 << D)) return;
    for_each_piece<D>(cube, [&](const SurfacePiece<D>& piece) {
      Facet facet;
      std::array<Point<D>, D> x;
      for (int v = 0; v < D; ++v) {
        facet[v] = corner(piece[v]);
        x[v] = facet[v].place;
      }
      if (has_twins(facet)) return;
      if (has_area<D>(x, spacing_)) facets.push_back(facet);
    });
  });
  return facets;
}

template <int D>
auto SurfaceLattice<D>::simplices_near(const std::vector<Box<D>>& boxes) const
    -> std::vector<Simplex> {
  std::vector<std::pair<std::int64_t, Cell<D>>> cells;
  for (const Box<D>& box : boxes) {
    Cell<D> first, last;
    bool is_beside = false;
    for (int a = 0; a < D; ++a) {
      const double from = std::floor((box.lower[a] - lower_[a]) / pitch_[a] - touching);
      const double to = std::floor((box.upper[a] - lower_[a]) / pitch_[a] + touching);
      is_beside = is_beside || to < 0 || from > extent_[a] - 2;
      first[a] = static_cast<std::int32_t>(std::clamp<double>(from, 0, extent_[a] - 2));
      last[a] = static_cast<std::int32_t>(std::clamp<double>(to, 0, extent_[a] - 2));
    }
    if (is_beside) continue;
    for_each_cell<D>(first, last, [&](const Cell<D>& cell) {
      cells.push_back({slot(cell), cell});
    });
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Simplex> simplices;
  for (const auto& [first_slot, cell] : cells) {
    const Cube cube = cube_at(cell).first;
    for_each_simplex<D>(cube, [&](const std::array<const SurfaceNode<D>*, D + 1>& nodes) {
      for_each_inside_part<D>(nodes, [&](const std::array<PartCorner<D>, D + 1>& part) {
        Simplex simplex;
        for (int v = 0; v <= D; ++v) simplex[v] = corner(part[v]);
        if (!has_twins(simplex)) simplices.push_back(simplex);
      });
    });
  }
  return simplices;
}

template class SurfaceLattice<2>;
template class SurfaceLattice<3>;

}  // namespace pliant::point_based
