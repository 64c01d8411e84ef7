#include "engine/undeformed/contact/pushed_surface.hpp"

#include <algorithm>
#include <utility>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

template <class T, int D>
PushedSurface<T, D>::PushedSurface(Body<T, D>& of, Displacements<T, D> displacements,
                                   ContactSurface<D> surface, ImpulseCarriers carriers,
                                   bool meets_tools)
    : body(&of), moved(displacements), shape(std::move(surface)), held(held_directions(of)) {
  if (carriers == ImpulseCarriers::first) {
    for (std::int32_t number = 0; number < shape.corners(); ++number) {
      first_carrier_.push_back({shape.shares(number).front().slot, 1});
    }
  }
  const BodyCarriers<T, D> particles(of, of.*moved, held);
  for (std::int32_t number = 0; number < shape.corners(); ++number) {
    MovableCorner corner{number, 0};
    for (int a = 0; a < D; ++a) {
      Point<D> axis = {};
      axis[a] = 1;
      const double along = compliance<D>(particles, bearing(number), axis);
      corner.compliance = std::max(corner.compliance, along);
    }
    if (!(corner.compliance > 0)) continue;
    corners.push_back(corner);
    if (number >= shape.first_inner) ++inner_corners;
  }
  if (meets_tools && shape.is_whole) find_neighbours();
}

template <class T, int D>
std::span<const Share> PushedSurface<T, D>::bearing(std::int32_t corner) const {
  if (first_carrier_.empty()) return shape.shares(corner);
  return std::span(first_carrier_).subspan(corner, 1);
}

template <class T, int D>
void PushedSurface<T, D>::find_neighbours() {
  facets_at_ = facets_around_corners(shape);
  neighbours_.resize(shape.corners());
  half_edge_.resize(shape.corners());
  for (const std::array<std::int32_t, D>& facet : shape.facet) {
    for (const std::int32_t corner : facet) {
      for (const std::int32_t other : facet) {
        std::vector<std::int32_t>& known = neighbours_[corner];
        if (other == corner || std::ranges::count(known, other) > 0) continue;
        known.push_back(other);
        const double length = norm<D>(difference<D>(shape.start[corner], shape.start[other]));
        half_edge_[corner] = std::max(half_edge_[corner], length / 2);
      }
    }
  }
}

template <class T, int D>
std::span<const std::int32_t> PushedSurface<T, D>::facets_at(std::int32_t corner) const {
  if (facets_at_.count() == 0) return {};
  return facets_at_[corner];
}

template <class T, int D>
std::span<const std::int32_t> PushedSurface<T, D>::neighbours(std::int32_t corner) const {
  if (neighbours_.empty()) return {};
  return neighbours_[corner];
}

template <class T, int D>
double PushedSurface<T, D>::half_edge(std::int32_t corner) const {
  return half_edge_.empty() ? 0 : half_edge_[corner];
}

template <class T, int D>
Point<D> PushedSurface<T, D>::place(std::int32_t corner) const {
  Point<D> x = carried<T, D>(body->*moved, shape.shares(corner));
  for (int a = 0; a < D; ++a) x[a] += shape.start[corner][a];
  return x;
}

template struct PushedSurface<double, 2>;
template struct PushedSurface<double, 3>;
template struct PushedSurface<float, 2>;
template struct PushedSurface<float, 3>;

}  // namespace pliant::undeformed
