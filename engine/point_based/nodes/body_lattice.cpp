#include "engine/point_based/nodes/body_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/mean_phi.hpp"
#include "kernels/layout.hpp"

namespace pliant::point_based {

namespace {

constexpr double on_lattice_point = 1e-9;  // [h] rounding errors of distances
constexpr double least_share = 1e-9;       // of a sub-cell, rounding error
constexpr double least_change = 0.1;       // [h] change of phi over a cell, at kinks of phi

}  // namespace

template <int D>
Point<D> lattice_pitch(const Shape& shape, double spacing) {
  const Box<3> box = bounding_box(shape);
  Point<D> pitch;
  for (int a = 0; a < D; ++a) {
    const double side = box.upper[a] - box.lower[a];
    pitch[a] = side / std::max(1.0, std::round(side / spacing));
  }
  return pitch;
}

template <int D>
BodyLattice<D>::BodyLattice(const Shape& shape, double spacing)
    : shape_(shape),
      spacing_(spacing),
      has_mesh_(contains_mesh(shape)),
      pitch_(lattice_pitch<D>(shape, spacing)) {
  const Box<3> box = bounding_box(shape);
  std::int64_t count = 1;
  for (int a = 0; a < D; ++a) {
    const auto cells =
        static_cast<std::int32_t>(std::round((box.upper[a] - box.lower[a]) / pitch_[a]));
    start_[a] = box.lower[a] - pitch_[a];
    extent_[a] = cells + 3;
    stride_[a] = count;
    count *= extent_[a];
  }
  phi_.reserve(count);
  DistanceWalk distance(shape, D, 2 * spacing);
  for_each_cell<D>({}, last(0), [&](const Cell<D>& point) {
    const double phi = distance(padded<D>(place(point))) / spacing;
    // Points on the surface always count as inside: edges of the body stay sharp.
    phi_.push_back(std::abs(phi) < on_lattice_point ? 0 : phi);
  });
  if (has_mesh_) mean_phi_ = mean_phi<D>(phi_, extent_);
}

template <int D>
double BodyLattice<D>::cell_volume() const {
  double volume = 1;
  for (const double side : pitch_) volume *= side;
  return volume;
}

template <int D>
Cell<D> BodyLattice<D>::last(int less) const {
  Cell<D> cell;
  for (int a = 0; a < D; ++a) cell[a] = extent_[a] - 1 - less;
  return cell;
}

template <int D>
std::int64_t BodyLattice<D>::index(const Cell<D>& point) const {
  std::int64_t sum = 0;
  for (int a = 0; a < D; ++a) sum += stride_[a] * point[a];
  return sum;
}

template <int D>
std::int64_t BodyLattice<D>::corner(const Cell<D>& cell, int c) const {
  std::int64_t sum = index(cell);
  for (int a = 0; a < D; ++a) sum += (c >> a & 1) * stride_[a];
  return sum;
}

template <int D>
Point<D> BodyLattice<D>::place(const Cell<D>& point) const {
  Point<D> x;
  for (int a = 0; a < D; ++a) x[a] = start_[a] + point[a] * pitch_[a];
  return x;
}

// A cell without a point inside may still contain a thin part of the body.
template <int D>
auto BodyLattice<D>::filling(const Cell<D>& cell) const -> Filling {
  const std::vector<double>& phi = has_mesh_ ? mean_phi_ : phi_;
  double least = phi[index(cell)], most = least, longest = 0;
  for (int c = 1; c < corners; ++c) {
    least = std::min(least, phi[corner(cell, c)]);
    most = std::max(most, phi[corner(cell, c)]);
  }
  for (const double side : pitch_) longest += side * side;
  if (least > std::sqrt(longest) / 2 / spacing_) return Filling::none;
  return most <= 0 ? Filling::all : Filling::part;
}

template <int D>
std::vector<double> BodyLattice<D>::filled(const Cell<D>& cell) const {
  std::vector<double> share(kernels::power(sub_cells, D), 1.0);
  if (filling(cell) == Filling::all) return share;
  for (int k = 0; k < static_cast<int>(share.size()); ++k) {
    share[k] = filled_at(cell, middle(cell, k));
    if (share[k] < least_share) share[k] = 0;
  }
  return share;
}

// phi over its change across the sub-cell, as for a plane surface. The sides of a sub-cell differ
// if the spacing does not divide those of the body.
template <int D>
double BodyLattice<D>::filled_at(const Cell<D>& cell, const Point<D>& x) const {
  const double phi = distance_in(cell, x);
  const double longest = *std::max_element(pitch_.begin(), pitch_.end()) / spacing_ / sub_cells;
  if (std::abs(phi) > longest) return phi < 0 ? 1 : 0;
  const double across = std::max(change_across(cell, x), least_change / sub_cells);
  return std::clamp(0.5 - phi / across, 0.0, 1.0);
}

template <int D>
double BodyLattice<D>::change_across(const Cell<D>& cell, const Point<D>& x) const {
  const Vector normal = has_mesh_ ? Vector{} : outward_direction(shape_, padded<D>(x), D);
  double square = 0;
  for (int a = 0; a < D; ++a) {
    double change = normal[a] * pitch_[a] / spacing_ / sub_cells;
    if (has_mesh_) {
      Point<D> from = x, to = x;
      from[a] -= pitch_[a] / (2 * sub_cells);
      to[a] += pitch_[a] / (2 * sub_cells);
      change = between(cell, to) - between(cell, from);
    }
    square += change * change;
  }
  return std::sqrt(square);
}

// phi is interpolated between the corners for meshes, where distances are expensive, and exact for
// other shapes.
template <int D>
double BodyLattice<D>::distance_in(const Cell<D>& cell, const Point<D>& x) const {
  return has_mesh_ ? between(cell, x) : signed_distance(shape_, padded<D>(x), D) / spacing_;
}

template <int D>
Point<D> BodyLattice<D>::middle(const Cell<D>& cell, int sub_cell) const {
  Point<D> x = place(cell);
  for (int a = 0, rest = sub_cell; a < D; ++a, rest /= sub_cells) {
    x[a] += (rest % sub_cells + 0.5) / sub_cells * pitch_[a];
  }
  return x;
}

template <int D>
double BodyLattice<D>::between(const Cell<D>& cell, const Point<D>& x) const {
  const Point<D> from = place(cell);
  double value = 0;
  for (int c = 0; c < corners; ++c) {
    double weight = 1;
    for (int a = 0; a < D; ++a) {
      const double s = (x[a] - from[a]) / pitch_[a];
      weight *= c >> a & 1 ? s : 1 - s;
    }
    value += weight * mean_phi_[corner(cell, c)];
  }
  return value;
}

template Point<2> lattice_pitch<2>(const Shape&, double);
template Point<3> lattice_pitch<3>(const Shape&, double);
template class BodyLattice<2>;
template class BodyLattice<3>;

}  // namespace pliant::point_based
