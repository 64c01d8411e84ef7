#include "engine/undeformed/contact/corner_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/undeformed/contact/facet_point.hpp"

namespace pliant::undeformed {

namespace {

constexpr double deepest_of_two = 1;    // largest depth of a corner in another body [spacing]
constexpr double deepest_of_one = 0.5;  // in its own body
constexpr double apart_at_rest =
    3;  // initial distance of parts of one body that can meet [spacing]
constexpr double least_ahead =
    0.5;  // cosine between the normal and the direction to a facet across a slot
constexpr double without_rounding = 1 - 1e-6;

template <int D>
double distance_to_facet(const std::array<Point<D>, D>& c, const Point<D>& x) {
  const Point<D> way = way_from<D>(c, nearest_weights(c, x), x);
  return std::sqrt(dot<D>(way, way));
}

}  // namespace

template <class T, int D>
CornerSearch<T, D>::CornerSearch(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets)
    : corners_(corners),
      facets_(facets),
      same_(&corners == &facets),
      deepest_((same_ ? deepest_of_one : deepest_of_two) * facets.spacing()),
      pairs_(corners, facets, deepest_) {}

template <class T, int D>
void CornerSearch<T, D>::list(bool foreign) {
  pairs_.measure(foreign);
  corner_.clear();
  patch_.clear();
  clearance_.clear();
  begin_.assign(1, 0);
  near_.clear();
  least_clearance_ = std::numeric_limits<double>::infinity();
  const std::span<const Pair> pairs = pairs_.pairs();
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto end = std::find_if(
        first, pairs.end(), [first](const Pair& pair) { return pair.corners != first->corners; });
    list_patch({first, end});
    first = end;
  }
}

template <class T, int D>
void CornerSearch<T, D>::list_patch(std::span<const Pair> pairs_of_patch) {
  const double reach = deepest_ + pairs_.margin();
  const std::int32_t patch = pairs_of_patch.front().corners;
  near_facets_.clear();
  for (const Pair& pair : pairs_of_patch) {
    if (!pair.is_listed) continue;
    for (const std::int32_t f : facets_.patches().facets(pair.facets)) {
      Box<D> around;
      for (const std::int32_t c : facets_.facet(f)) around.grow(facets_.place(c));
      if (squared_gap(around, pairs_.box_of_corners(patch)) > reach * reach) continue;
      facets_.find_normal(f);
      near_facets_.push_back({f, around});
    }
  }
  if (near_facets_.empty()) return;
  for (const std::int32_t corner : corners_.patches().corners(patch)) list_corner(corner, patch);
}

// Facets that may become the nearest are sorted by distance. The others within reach follow
// unsorted, since they are rarely needed.
template <class T, int D>
void CornerSearch<T, D>::list_corner(std::int32_t corner, std::int32_t patch) {
  const double margin = pairs_.margin(), reach = deepest_ + margin;
  const Point<D>& x = corners_.place(corner);
  const Box<D> point{x, x};
  reached_.clear();
  double clearance = std::numeric_limits<double>::infinity();
  for (const auto& [f, around] : near_facets_) {
    const double square = squared_gap(point, around);
    if (square > reach * reach || (same_ && are_neighbours(corner, facets_.facet(f)))) continue;
    const double height = facets_.height(f, x);
    const double distance = std::max(std::sqrt(square), std::abs(height));
    clearance = std::min(clearance, height > 0 ? distance : 0);
    if (distance <= reach) reached_.push_back({f, distance});
  }
  clearance *= without_rounding;
  if (reached_.empty() || clearance > margin) return;
  double nearest = reach;
  const auto by_distance = [](const Near& a, const Near& b) {
    return std::pair(a.distance, a.facet) < std::pair(b.distance, b.facet);
  };
  std::iter_swap(reached_.begin(), std::min_element(reached_.begin(), reached_.end(), by_distance));
  for (Near& near : reached_) {
    if (near.distance > nearest + 2 * margin) continue;
    near.distance = distance_to_facet<D>(facets_.places(near.facet), x);
    if (near.distance < nearest && corners_.opposes(corner, facets_.facet_normal(near.facet))) {
      nearest = near.distance;
    }
  }
  const double limit = nearest + 2 * margin;
  const auto beyond = std::partition(reached_.begin(), reached_.end(),
                                     [limit](const Near& near) { return near.distance <= limit; });
  std::sort(reached_.begin(), beyond, by_distance);
  for (auto near = beyond; near < reached_.end(); ++near) near->distance = limit;
  for (Near& near : reached_) near.distance *= without_rounding;
  near_.insert(near_.end(), reached_.begin(), reached_.end());
  corner_.push_back(corner);
  patch_.push_back(patch);
  clearance_.push_back(clearance);
  least_clearance_ = std::min(least_clearance_, clearance);
  begin_.push_back(near_.size());
}

// Across a slot, the corner is in front of the facet. Across a thin layer it is behind it, and on
// the same face it is beside it.
template <class T, int D>
bool CornerSearch<T, D>::are_neighbours(std::int32_t corner,
                                        const std::array<std::int32_t, D>& facet) const {
  const auto& start = facets_.start();
  const double apart = apart_at_rest * facets_.spacing();
  std::array<Point<D>, D> c;
  for (int v = 0; v < D; ++v) c[v] = start[facet[v]];
  Point<D> normal = area_vector<D>(c);
  normalise<D>(normal);
  return std::any_of(c.begin(), c.end(), [&](const Point<D>& other) {
    const Point<D> r = difference<D>(start[corner], other);
    const double square = dot<D>(r, r);
    return square < apart * apart && dot<D>(r, normal) < least_ahead * std::sqrt(square);
  });
}

template <class T, int D>
void CornerSearch<T, D>::watch() {
  for (const std::int32_t corner : corner_) corners_.watch(corner);
  for (const Near& near : near_) {
    for (const std::int32_t corner : facets_.facet(near.facet)) facets_.watch(corner);
  }
}

template <class T, int D>
void CornerSearch<T, D>::find(std::size_t first, std::size_t end,
                              std::vector<Penetration<D>>& touches) const {
  Penetration<D> touch;
  for (std::size_t i = first; i < end; ++i) {
    const double moved = pairs_.moved(patch_[i]);
    if (clearance_[i] <= moved && finds(i, moved, touch)) touches.push_back(touch);
  }
}

// Finds the nearest point of the facets that face the corner; in a tie the first facet wins. Facets
// cannot be nearer than at the marks by more than the motion since.
template <class T, int D>
bool CornerSearch<T, D>::finds(std::size_t candidate, double moved, Penetration<D>& touch) const {
  const std::int32_t corner = corner_[candidate];
  const Point<D> x = corners_.place(corner);
  double nearest = deepest_, at_height = 0;
  Point<D> inwards = {};
  touch.facet = std::numeric_limits<std::int32_t>::max();
  for (std::size_t i = begin_[candidate]; i < begin_[candidate + 1]; ++i) {
    if (near_[i].distance - moved > nearest) break;
    const std::int32_t f = near_[i].facet;
    const double height = facets_.height(f, x);
    if (std::abs(height) > nearest) continue;
    const std::array<Point<D>, D> c = facets_.places(f);
    const std::array<double, D> weight = nearest_weights(c, x);
    const Point<D> from_facet = way_from<D>(c, weight, x);
    const double distance = std::sqrt(dot<D>(from_facet, from_facet));
    const Point<D>& normal = facets_.facet_normal(f);
    if (std::pair(distance, f) >= std::pair(nearest, touch.facet)) continue;
    if (!corners_.opposes(corner, normal)) continue;
    nearest = distance;
    at_height = height;
    inwards = from_facet;
    touch = {corner, f, weight, normal, -distance};
  }
  if (nearest == deepest_) return false;
  const double rounding =
      16 * std::sqrt(double{std::numeric_limits<T>::epsilon()}) * facets_.spacing();
  if (nearest * nearest - at_height * at_height <= rounding * rounding) return at_height < 0;
  for (int a = 0; a < D; ++a) touch.normal[a] = -inwards[a] / nearest;
  return dot<D>(inwards, facets_.outwards(touch.facet, touch.weight)) < 0;
}

template class CornerSearch<double, 2>;
template class CornerSearch<double, 3>;
template class CornerSearch<float, 2>;
template class CornerSearch<float, 3>;

}  // namespace pliant::undeformed
