#include "engine/undeformed/contact/moving_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::undeformed {

namespace {

constexpr double least_opposition = -0.5;  // cosine of the normals of surfaces that can touch

/// Size of typical facets, weighted by area: cells that the surface hardly cuts have tiny facets.
template <int D>
double size_of_facets(const ContactSurface<D>& surface) {
  double area = 0, squares = 0;
  for (const auto& facet : surface.facet) {
    std::array<Point<D>, D> x;
    for (int v = 0; v < D; ++v) x[v] = surface.start[facet[v]];
    const Point<D> n = area_vector<D>(x);
    area += std::sqrt(dot<D>(n, n));
    squares += dot<D>(n, n);
  }
  const double mean = area > 0 ? squares / area : 0;
  return D == 2 ? mean : std::sqrt(2 * mean);
}

/// Slots of all carriers, ascending. Replaces the slots in shares by the numbers of carriers.
template <int D>
std::vector<std::int32_t> number_carriers(ContactSurface<D>& surface) {
  std::vector<std::int32_t> slots;
  for (const Share& share : surface.share) slots.push_back(share.slot);
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  for (Share& share : surface.share) {
    const auto at = std::lower_bound(slots.begin(), slots.end(), share.slot);
    share.slot = static_cast<std::int32_t>(at - slots.begin());
  }
  for (std::int32_t c = 0; c < surface.corners(); ++c) {
    std::sort(surface.share.begin() + surface.first_share[c],
              surface.share.begin() + surface.first_share[c + 1],
              [](const Share& a, const Share& b) { return a.slot < b.slot; });
  }
  return slots;
}

/// Angle of a triangle at its corner `v`; in 2D all facets have equal weight.
double angle_at(const std::array<Point<2>, 2>&, int) { return 1; }
double angle_at(const std::array<Point<3>, 3>& x, int v) {
  Point<3> a = difference<3>(x[(v + 1) % 3], x[v]), b = difference<3>(x[(v + 2) % 3], x[v]);
  normalise<3>(a);
  normalise<3>(b);
  return std::acos(std::clamp(dot<3>(a, b), -1., 1.));
}

}  // namespace

template <class T, int D>
MovingSurface<T, D>::MovingSurface(Body<T, D>& body, Displacements<T, D> moved,
                                   ContactSurface<D> surface)
    : body_(&body),
      moved_(moved),
      surface_(std::move(surface)),
      held_(held_directions(body)),
      spacing_(size_of_facets(surface_)) {
  for (const std::int32_t slot : number_carriers(surface_)) {
    const auto at = held_.find(slot);
    carriers_.push_back(
        {slot, double{body.inverse_mass[slot]}, at == held_.end() ? nullptr : &at->second});
  }
  around_ = facets_around_corners(surface_);
  patches_ = SurfacePatches<D>(surface_, carriers_.size(), spacing_);
  displacement_.resize(carriers_.size());
  marked_.resize(carriers_.size());
  motion_.resize(carriers_.size());
  place_.resize(surface_.corners());
  normal_.resize(surface_.facet.size());
  is_carrier_watched_.resize(carriers_.size());
  is_corner_watched_.resize(place_.size());
  is_ring_watched_.resize(place_.size());
  is_facet_watched_.resize(normal_.size());
}

template <class T, int D>
void MovingSurface<T, D>::read_motion() {
  const auto& displacement = body_->*moved_;
  for (std::size_t i = 0; i < carriers_.size(); ++i) {
    for (int a = 0; a < D; ++a) displacement_[i][a] = displacement[a][carriers_[i].slot];
  }
  patches_.measure(displacement_, marked_);
}

template <class T, int D>
void MovingSurface<T, D>::mark() {
  marked_ = displacement_;
  patches_.measure(displacement_, marked_);
}

template <class T, int D>
void MovingSurface<T, D>::find_marked_places(std::size_t patch) {
  for (const std::int32_t corner : patches_.corners(patch)) find_place(corner, marked_);
  for (const std::int32_t facet : patches_.facets(patch)) {
    for (const std::int32_t corner : surface_.facet[facet]) find_place(corner, marked_);
  }
}

template <class T, int D>
void MovingSurface<T, D>::watch_none() {
  for (const std::int32_t corner : watched_corners_) {
    is_corner_watched_[corner] = is_ring_watched_[corner] = false;
  }
  for (const std::int32_t facet : watched_facets_) is_facet_watched_[facet] = false;
  for (const std::int32_t carrier : watched_carriers_) is_carrier_watched_[carrier] = false;
  watched_corners_.clear();
  watched_facets_.clear();
  watched_carriers_.clear();
}

template <class T, int D>
void MovingSurface<T, D>::watch(std::int32_t corner) {
  if (is_ring_watched_[corner]) return;
  is_ring_watched_[corner] = true;
  watch_corner(corner);
  for (const std::int32_t facet : around_[corner]) {
    if (is_facet_watched_[facet]) continue;
    is_facet_watched_[facet] = true;
    watched_facets_.push_back(facet);
    for (const std::int32_t other : surface_.facet[facet]) watch_corner(other);
  }
}

template <class T, int D>
void MovingSurface<T, D>::watch_corner(std::int32_t corner) {
  if (is_corner_watched_[corner]) return;
  is_corner_watched_[corner] = true;
  watched_corners_.push_back(corner);
  for (const Share& share : surface_.shares(corner)) {
    if (is_carrier_watched_[share.slot]) continue;
    is_carrier_watched_[share.slot] = true;
    watched_carriers_.push_back(share.slot);
  }
}

template <class T, int D>
void MovingSurface<T, D>::find_places(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) find_place(watched_corners_[i], displacement_);
}

template <class T, int D>
void MovingSurface<T, D>::find_normals(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) find_normal(watched_facets_[i]);
}

template <class T, int D>
void MovingSurface<T, D>::find_place(std::int32_t corner,
                                     const std::vector<Point<D>>& displacement) {
  Point<D> x = {};
  for (const Share& share : surface_.shares(corner)) {
    for (int a = 0; a < D; ++a) x[a] += share.weight * displacement[share.slot][a];
  }
  for (int a = 0; a < D; ++a) x[a] += surface_.start[corner][a];
  place_[corner] = x;
}

template <class T, int D>
void MovingSurface<T, D>::find_normal(std::int32_t facet) {
  normal_[facet] = area_vector<D>(places(facet));
  normalise<D>(normal_[facet]);
}

template <class T, int D>
std::array<Point<D>, D> MovingSurface<T, D>::places(std::int32_t facet) const {
  std::array<Point<D>, D> x;
  for (int v = 0; v < D; ++v) x[v] = place_[surface_.facet[facet][v]];
  return x;
}

template <class T, int D>
double MovingSurface<T, D>::height(std::int32_t facet, const Point<D>& x) const {
  return dot<D>(difference<D>(x, place_[surface_.facet[facet][0]]), normal_[facet]);
}

template <class T, int D>
Point<D> MovingSurface<T, D>::outwards(std::int32_t facet,
                                       const std::array<double, D>& weight) const {
  std::array<std::int32_t, D> carrying = {};
  int count = 0;
  for (int v = 0; v < D; ++v) {
    if (weight[v] > 0) carrying[count++] = surface_.facet[facet][v];
  }
  if (count == D) return normal_[facet];
  Point<D> sum = {};
  for (const std::int32_t around : around_[carrying[0]]) {
    const auto& corners = surface_.facet[around];
    const auto first = std::find(corners.begin(), corners.end(), carrying[0]);
    if (count > 1 && std::find(corners.begin(), corners.end(), carrying[1]) == corners.end()) {
      continue;
    }
    const double share =
        count > 1 ? 1 : angle_at(places(around), static_cast<int>(first - corners.begin()));
    for (int a = 0; a < D; ++a) sum[a] += share * normal_[around][a];
  }
  return sum;
}

template <class T, int D>
bool MovingSurface<T, D>::opposes(std::int32_t corner, const Point<D>& normal) const {
  const auto facets = around_[corner];
  return facets.empty() || std::any_of(facets.begin(), facets.end(), [&](std::int32_t facet) {
           return dot<D>(normal_[facet], normal) <= least_opposition;
         });
}

template <class T, int D>
void MovingSurface<T, D>::read_velocities(std::size_t first, std::size_t end) {
  for (std::size_t w = first; w < end; ++w) {
    const std::int32_t i = watched_carriers_[w];
    for (int a = 0; a < D; ++a) {
      motion_[i].velocity[a] = body_->velocity[a][carriers_[i].slot];
      motion_[i].shift[a] = 0;
    }
  }
}

template <class T, int D>
void MovingSurface<T, D>::write_motion(double rate) {
  auto& displacement = body_->*moved_;
  for (const std::int32_t i : watched_carriers_) {
    const std::int32_t slot = carriers_[i].slot;
    for (int a = 0; a < D; ++a) {
      T& velocity = body_->velocity[a][slot];
      const double change = motion_[i].velocity[a] - velocity;
      velocity = static_cast<T>(motion_[i].velocity[a]);
      body_->add_contact_force(slot, a, rate * body_->mass[slot] * change);
      displacement[a][slot] += static_cast<T>(motion_[i].shift[a]);
    }
  }
}

template class MovingSurface<double, 2>;
template class MovingSurface<double, 3>;
template class MovingSurface<float, 2>;
template class MovingSurface<float, 3>;

}  // namespace pliant::undeformed
