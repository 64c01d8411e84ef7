#include "engine/undeformed/corner_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/blocks/box_tree.hpp"
#include "engine/geometry/triangle_foot.hpp"

namespace pliant::undeformed {

namespace {

constexpr double deepest_of_two = 1;    // of a corner in another body [spacing]
constexpr double deepest_of_one = 0.5;  // in the same one
constexpr double apart_at_rest = 3;     // parts of one body that can meet [spacing]
constexpr double least_ahead = 0.5;     // cosine to the normal, of what lies across a slot
constexpr double without_rounding = 1 - 1e-6;
constexpr double list_margin = 0.5;  // that patches move between two lists [spacing]
constexpr double pair_margin = 4;    // that bodies move between two pairings, at least [spacing]

}  // namespace

std::array<double, 2> nearest_weights(const std::array<Point<2>, 2>& c, const Point<2>& x) {
  const Point<2> along = difference<2>(c[1], c[0]);
  const double square = dot<2>(along, along);
  if (square == 0) return {1, 0};
  const double t = std::clamp(dot<2>(difference<2>(x, c[0]), along) / square, 0., 1.);
  return {1 - t, t};
}
std::array<double, 3> nearest_weights(const std::array<Point<3>, 3>& c, const Point<3>& x) {
  const auto vector = [](const Point<3>& p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  return foot_on_triangle({vector(c[0]), vector(c[1]), vector(c[2])}, vector(x)).weight;
}

namespace {

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
      margin_(list_margin * facets.spacing()),
      box_(corners.patches().count()),
      other_box_(facets.patches().count()),
      moved_(box_.size()) {}

// Seen from the mean motion of both: bodies that fly together keep their pairs.
template <class T, int D>
double CornerSearch<T, D>::motion_in_common_frame() const {
  Point<D> frame;
  for (int a = 0; a < D; ++a) {
    frame[a] = (corners_.patches().drift()[a] + facets_.patches().drift()[a]) / 2;
  }
  return corners_.patches().largest_motion(frame) + facets_.patches().largest_motion(frame);
}

template <class T, int D>
bool CornerSearch<T, D>::holds() {
  if (used_ + motion_in_common_frame() + margin_ > wide_) pair_patches();
  std::fill(moved_.begin(), moved_.end(), 0.);
  most_moved_ = 0;
  for (const Pair& pair : pairs_) {
    const double moved = relative_motion<D>(corners_.patches().motion(pair.corners),
                                            facets_.patches().motion(pair.facets));
    if (moved > pair.room) return false;
    if (!pair.is_listed) continue;
    moved_[pair.corners] = std::max(moved_[pair.corners], moved);
    most_moved_ = std::max(most_moved_, moved);
  }
  return true;
}

template <class T, int D>
void CornerSearch<T, D>::expect_marks() {
  used_ += motion_in_common_frame();
}

template <class T, int D>
Box<D> CornerSearch<T, D>::box_of_corners(std::size_t patch) const {
  Box<D> box;
  for (const std::int32_t corner : corners_.patches().corners(patch)) {
    box.grow(corners_.place(corner));
  }
  return box;
}

template <class T, int D>
Box<D> CornerSearch<T, D>::box_of_facets(std::size_t patch) const {
  Box<D> box;
  for (const std::int32_t facet : facets_.patches().facets(patch)) {
    for (const std::int32_t corner : facets_.facet(facet)) box.grow(facets_.place(corner));
  }
  return box;
}

// From the marks. What is not paired may move by `wide_`.
template <class T, int D>
void CornerSearch<T, D>::pair_patches() {
  used_ = 0;
  Box<D> all, all_others;
  for (std::size_t p = 0; p < box_.size(); ++p) corners_.find_marked_places(p);
  for (std::size_t p = 0; p < other_box_.size(); ++p) facets_.find_marked_places(p);
  for (std::size_t p = 0; p < box_.size(); ++p) all.grow(box_[p] = box_of_corners(p));
  for (std::size_t p = 0; p < other_box_.size(); ++p) {
    all_others.grow(other_box_[p] = box_of_facets(p));
  }
  wide_ = std::max({pair_margin * facets_.spacing(), 2 * motion_in_common_frame() + margin_,
                    without_rounding * std::sqrt(squared_gap(all, all_others)) - deepest_});
  const double reach = (deepest_ + wide_) / without_rounding;
  pairs_.clear();
  const BoxTree<D> tree(other_box_);
  for (std::size_t p = 0; p < box_.size(); ++p) {
    tree.for_each_near(box_[p], reach * reach, 0, [&](std::size_t q) {
      pairs_.push_back({static_cast<std::int32_t>(p), static_cast<std::int32_t>(q), 0, false});
    });
  }
  paired_.clear();
  paired_others_.clear();
  for (const Pair& pair : pairs_) {
    paired_.push_back(pair.corners);
    paired_others_.push_back(pair.facets);
  }
  for (std::vector<std::int32_t>* patches : {&paired_, &paired_others_}) {
    std::sort(patches->begin(), patches->end());
    patches->erase(std::unique(patches->begin(), patches->end()), patches->end());
  }
  find_rooms();
}

template <class T, int D>
void CornerSearch<T, D>::find_rooms() {
  for (Pair& pair : pairs_) {
    const double gap = std::sqrt(squared_gap(box_[pair.corners], other_box_[pair.facets]));
    pair.is_listed = gap <= deepest_ + margin_;
    pair.room = without_rounding * (pair.is_listed ? margin_ : gap - deepest_);
  }
}

template <class T, int D>
void CornerSearch<T, D>::list(bool foreign) {
  if (foreign) pair_patches();
  corner_.clear();
  patch_.clear();
  clearance_.clear();
  begin_.assign(1, 0);
  near_.clear();
  least_clearance_ = std::numeric_limits<double>::infinity();
  for (const std::int32_t p : paired_) corners_.find_marked_places(p);
  for (const std::int32_t p : paired_others_) facets_.find_marked_places(p);
  for (const std::int32_t p : paired_) box_[p] = box_of_corners(p);
  for (const std::int32_t p : paired_others_) other_box_[p] = box_of_facets(p);
  find_rooms();
  for (std::size_t first = 0; first < pairs_.size();) {
    std::size_t end = first;
    while (end < pairs_.size() && pairs_[end].corners == pairs_[first].corners) ++end;
    list_patch(first, end);
    first = end;
  }
}

template <class T, int D>
void CornerSearch<T, D>::list_patch(std::size_t first_pair, std::size_t end_pair) {
  const double reach = deepest_ + margin_;
  near_facets_.clear();
  for (std::size_t i = first_pair; i < end_pair; ++i) {
    if (!pairs_[i].is_listed) continue;
    for (const std::int32_t f : facets_.patches().facets(pairs_[i].facets)) {
      Box<D> around;
      for (const std::int32_t c : facets_.facet(f)) around.grow(facets_.place(c));
      if (squared_gap(around, box_[pairs_[i].corners]) > reach * reach) continue;
      facets_.find_normal(f);
      near_facets_.push_back({f, around});
    }
  }
  if (near_facets_.empty()) return;
  const std::int32_t patch = pairs_[first_pair].corners;
  for (const std::int32_t corner : corners_.patches().corners(patch)) list_corner(corner, patch);
}

// Facets as near as the nearest one can become are sorted by distance; the others that the corner
// may reach follow in no order, as hardly a search comes to them.
template <class T, int D>
void CornerSearch<T, D>::list_corner(std::int32_t corner, std::int32_t patch) {
  const double reach = deepest_ + margin_;
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
  if (reached_.empty() || clearance > margin_) return;
  double nearest = reach;
  const auto by_distance = [](const Near& a, const Near& b) {
    return std::pair(a.distance, a.facet) < std::pair(b.distance, b.facet);
  };
  std::iter_swap(reached_.begin(), std::min_element(reached_.begin(), reached_.end(), by_distance));
  for (Near& near : reached_) {
    if (near.distance > nearest + 2 * margin_) continue;
    near.distance = distance_to_facet<D>(facets_.places(near.facet), x);
    if (near.distance < nearest && corners_.opposes(corner, facets_.facet_normal(near.facet))) {
      nearest = near.distance;
    }
  }
  const double limit = nearest + 2 * margin_;
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

// Across a slot a corner lies in front of a facet; across a layer behind it, and on the same face
// beside it.
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
                              std::vector<Touch<D>>& touches) const {
  Touch<D> touch;
  for (std::size_t i = first; i < end; ++i) {
    const double moved = moved_[patch_[i]];
    if (clearance_[i] <= moved && finds(i, moved, touch)) touches.push_back(touch);
  }
}

// The nearest point of the facets that face the corner, of the first facet where several have it.
// No facet has come nearer than its distance at the marks less the motion since.
template <class T, int D>
bool CornerSearch<T, D>::finds(std::size_t candidate, double moved, Touch<D>& touch) const {
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
