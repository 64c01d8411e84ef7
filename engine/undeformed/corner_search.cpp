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
constexpr double list_margin = 0.5;  // that surfaces move between two lists [spacing]

template <int D>
Box<D> box_around(const std::vector<Point<D>>& places) {
  Box<D> box;
  for (const Point<D>& x : places) box.grow(x);
  return box;
}

/// Whether all of a facet is farther away than `distance`, by its first corner.
template <int D>
bool is_beyond(const std::array<Point<D>, D>& c, const Point<D>& x, double distance) {
  double size = 0;
  for (int v = 1; v < D; ++v) {
    const Point<D> side = difference<D>(c[v], c[0]);
    size = std::max(size, dot<D>(side, side));
  }
  const double reach = (distance + std::sqrt(size)) / without_rounding;
  const Point<D> r = difference<D>(x, c[0]);
  return dot<D>(r, r) > reach * reach;
}

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

template <class T, int D>
CornerSearch<T, D>::CornerSearch(const MovingSurface<T, D>& corners,
                                 const MovingSurface<T, D>& facets)
    : corners_(corners),
      facets_(facets),
      same_(&corners == &facets),
      deepest_((same_ ? deepest_of_one : deepest_of_two) * facets.spacing()) {}

template <class T, int D>
double CornerSearch<T, D>::list() {
  corner_.clear();
  begin_.assign(1, 0);
  near_.clear();
  clearance_.clear();
  least_clearance_ = std::numeric_limits<double>::infinity();
  const double margin = list_margin * facets_.spacing(), reach = deepest_ + margin;
  const std::vector<Point<D>>& place = corners_.all_places();
  const std::vector<Point<D>>& other_place = facets_.all_places();
  const Box<D> box = box_around<D>(place), other_box = box_around<D>(other_place);
  const double gap = std::sqrt(squared_gap(box, other_box));
  if (gap > reach) return gap - deepest_;
  const auto& facets = facets_.surface().facet;
  std::vector<std::int32_t> number;
  std::vector<Box<D>> boxes;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    Box<D> around;
    for (const std::int32_t corner : facets[f]) around.grow(other_place[corner]);
    if (squared_gap(around, box) > reach * reach) continue;
    number.push_back(static_cast<std::int32_t>(f));
    boxes.push_back(around);
  }
  const BoxTree<D> tree(std::move(boxes));
  for (std::int32_t c = 0; c < corners_.surface().corners(); ++c) {
    const Box<D> point{place[c], place[c]};
    if (squared_gap(point, other_box) > reach * reach) continue;
    double clearance = reach;
    tree.for_each_near(point, reach * reach, 0, [&](std::size_t i) {
      const std::int32_t f = number[i];
      if (same_ && are_neighbours(c, facets[f])) return;
      near_.push_back(f);
      const double height = facets_.height(f, place[c]);
      clearance = std::min(clearance, std::max(height, std::sqrt(squared_gap(point, tree[i]))));
      if (height <= 0) clearance = 0;
    });
    if (near_.size() == begin_.back()) continue;
    corner_.push_back(c);
    begin_.push_back(near_.size());
    clearance_.push_back(without_rounding * clearance);
    least_clearance_ = std::min(least_clearance_, clearance_.back());
  }
  return margin;
}

// Across a slot a corner lies in front of a facet; across a layer behind it, and on the same face
// beside it.
template <class T, int D>
bool CornerSearch<T, D>::are_neighbours(std::int32_t corner,
                                        const std::array<std::int32_t, D>& facet) const {
  const auto& start = facets_.surface().start;
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
void CornerSearch<T, D>::watch(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets) const {
  for (const std::int32_t corner : corner_) corners.watch(corner);
  for (const std::int32_t facet : near_) {
    for (const std::int32_t corner : facets_.surface().facet[facet]) facets.watch(corner);
  }
}

template <class T, int D>
void CornerSearch<T, D>::find(double moved, std::size_t first, std::size_t end,
                              std::vector<Touch<D>>& touches) const {
  Touch<D> touch;
  for (std::size_t i = first; i < end; ++i) {
    if (clearance_[i] > moved) continue;
    const auto facets = std::span(near_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
    if (finds(corner_[i], facets, touch)) touches.push_back(touch);
  }
}

// The nearest point of the facets that face the corner. Beside an edge, the mean normals of the
// corners around it tell inside from outside.
template <class T, int D>
bool CornerSearch<T, D>::finds(std::int32_t corner, std::span<const std::int32_t> facets,
                               Touch<D>& touch) const {
  const Point<D> x = corners_.place(corner);
  const bool is_before_all = std::all_of(facets.begin(), facets.end(),
                                         [&](std::int32_t f) { return facets_.height(f, x) >= 0; });
  if (is_before_all) return false;
  double nearest = deepest_, at_height = 0;
  Point<D> inwards = {};
  for (const std::int32_t f : facets) {
    const double height = facets_.height(f, x);
    if (std::abs(height) >= nearest) continue;
    const std::array<Point<D>, D> c = facets_.places(f);
    if (is_beyond<D>(c, x, nearest)) continue;
    const Point<D>& normal = facets_.facet_normal(f);
    const std::array<double, D> weight = nearest_weights(c, x);
    Point<D> from_facet = x;
    for (int v = 0; v < D; ++v) {
      for (int a = 0; a < D; ++a) from_facet[a] -= weight[v] * c[v][a];
    }
    const double distance = std::sqrt(dot<D>(from_facet, from_facet));
    if (distance >= nearest || !corners_.opposes(corner, normal)) continue;
    nearest = distance;
    at_height = height;
    inwards = from_facet;
    touch = {corner, f, weight, normal, -distance};
  }
  if (nearest == deepest_) return false;
  const double rounding =
      16 * std::sqrt(double{std::numeric_limits<T>::epsilon()}) * facets_.spacing();
  if (nearest * nearest - at_height * at_height <= rounding * rounding) return at_height < 0;
  Point<D> outwards = {};
  for (int v = 0; v < D; ++v) {
    if (touch.weight[v] == 0) continue;
    const Point<D> n = facets_.normal(facets_.surface().facet[touch.facet][v]);
    for (int a = 0; a < D; ++a) outwards[a] += touch.weight[v] * n[a];
  }
  for (int a = 0; a < D; ++a) touch.normal[a] = -inwards[a] / nearest;
  return dot<D>(inwards, outwards) < 0;
}

template class CornerSearch<double, 2>;
template class CornerSearch<double, 3>;
template class CornerSearch<float, 2>;
template class CornerSearch<float, 3>;

}  // namespace pliant::undeformed
