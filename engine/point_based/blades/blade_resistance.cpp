#include "engine/point_based/blades/blade_resistance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/point_based/forces/node_gradient.hpp"

namespace pliant::point_based {

namespace {

// Marks are at most H/2 apart along the edge and H/4 along its path, so that each swept place is
// within 0.3 H of one. A place `way_ahead` before the edge is not.
constexpr double longest_segment = 0.5, longest_way = 0.25, mark_reach = 0.3,
                 way_ahead = 0.4;  // [H]

template <std::size_t N>
double vector_length(const std::array<double, N>& v) {
  double square = 0;
  for (const double component : v) square += component * component;
  return std::sqrt(square);
}

template <class T, int D>
std::vector<std::int32_t> node_slots(const Body<T, D>& body) {
  std::vector<std::int32_t> slots;
  body.for_each_node([&](std::int64_t slot) { slots.push_back(static_cast<std::int32_t>(slot)); });
  return slots;
}

template <class T, int D>
std::vector<Point<D>> starts_of(const Body<T, D>& body, const std::vector<std::int32_t>& slots) {
  std::vector<Point<D>> starts;
  starts.reserve(slots.size());
  for (const std::int32_t slot : slots) starts.push_back(body.start[slot]);
  return starts;
}

}  // namespace

template <int D>
template <class T>
TissueMap<D>::TissueMap(const Body<T, D>& body, InsideTest<D> inside)
    : slot(node_slots(body)),
      start(starts_of(body, slot)),
      nodes(start),
      is_inside(std::move(inside)),
      size(body.resolution),
      swept(mark_reach * size) {}

template <class T, int D>
auto BladeResistance<T, D>::divide(const Station& station, double longest) -> std::vector<Segment> {
  std::vector<Segment> segments;
  if constexpr (D == 2) {
    segments.push_back({station.front(), {}, 1, 0, 0, true, {}, {}});
    return segments;
  }
  for (std::size_t k = 0; k + 1 < station.size(); ++k) {
    Point<D> along;
    for (int a = 0; a < D; ++a) along[a] = station[k + 1][a] - station[k][a];
    const double length = vector_length(along);
    if (length == 0) continue;
    const int count = static_cast<int>(std::ceil(length / longest));
    for (double& component : along) component /= length;
    for (int i = 0; i < count; ++i) {
      Segment segment{{}, along, length / count, k, (i + 0.5) / count, true, {}, {}};
      segment.middle = between(station, segment);
      segments.push_back(segment);
    }
  }
  return segments;
}

template <class T, int D>
Point<D> BladeResistance<T, D>::between(const Station& values, const Segment& segment) {
  Point<D> value = values[segment.point];
  if (segment.share == 0) return value;
  for (int a = 0; a < D; ++a) value[a] += segment.share * (values[segment.point + 1][a] - value[a]);
  return value;
}

// Finds the nodes of a segment; the weights vanish at the nearest node that is not among them.
template <class T, int D>
void BladeResistance<T, D>::find_nodes(Segment& segment, const TissueMap<D>& tissue) {
  const auto near = tissue.nodes.nearest(segment.middle, carriers + 1);
  const double farthest = near.back().distance;
  double sum = 0;
  for (int k = 0; k < carriers; ++k) {
    const auto& [distance, node] = near[std::min<std::size_t>(k, near.size() - 1)];
    segment.slot[k] = tissue.slot[node];
    segment.weight[k] = 1e-6 + 1 - distance * distance / (farthest * farthest);
    sum += segment.weight[k];
  }
  for (double& weight : segment.weight) weight /= sum;
}

template <class T, int D>
void BladeResistance<T, D>::follow(const Station& before, const Station& now,
                                   TissueMap<D>& tissue) {
  std::vector<Segment> segments = divide(now, longest_segment * tissue.size);
  for (Segment& segment : segments) {
    if (before.empty()) continue;
    const Point<D> from = between(before, segment);
    Point<D> way, next = segment.middle;
    double sliding = 0;
    for (int a = 0; a < D; ++a) {
      way[a] = segment.middle[a] - from[a];
      sliding += way[a] * segment.along[a];
    }
    for (int a = 0; a < D; ++a) way[a] -= sliding * segment.along[a];
    const double length = vector_length(way);
    if (length == 0) continue;
    for (int a = 0; a < D; ++a) next[a] += way_ahead * tissue.size / length * way[a];
    segment.is_new = !tissue.swept.is_cut(next);
  }
  for (const Segment& segment : segments) {
    const Point<D> from = before.empty() ? segment.middle : between(before, segment);
    Point<D> way;
    for (int a = 0; a < D; ++a) way[a] = segment.middle[a] - from[a];
    const int marks = 1 + static_cast<int>(vector_length(way) / (longest_way * tissue.size));
    for (int i = 1; i <= marks; ++i) {
      MaterialPoint<D> x = from;
      for (int a = 0; a < D; ++a) x[a] += way[a] * i / marks;
      tissue.swept.mark(x);
    }
  }
  std::erase_if(segments, [&](const Segment& s) { return !tissue.is_inside(s.middle); });
  for (Segment& segment : segments) find_nodes(segment, tissue);
  segments_ = std::move(segments);
}

template <class T, int D>
void BladeResistance<T, D>::load(const Station& velocity, Body<T, D>& body,
                                 BladeLoad<D>& sum) const {
  for (const Segment& segment : segments_) {
    const Point<D> w = between(velocity, segment);
    const std::int32_t nearest = segment.slot.front();
    const auto f = fitted_gradient(body, body.block_of(nearest), nearest);
    Point<D> v = {};
    double sliding = 0;
    for (int i = 0; i < D; ++i) {
      sliding += w[i] * segment.along[i];
      for (int j = 0; j < D; ++j) v[i] += f[D * i + j] * w[j];
    }
    const double speed = vector_length(v);
    if (speed == 0) continue;
    const double whole = vector_length(w);
    const double across = std::sqrt(std::max(0., whole * whole - sliding * sliding));
    const double taken = segment.is_new ? cut_.resistance * across / speed : 0;
    const double size = segment.length * (taken + cut_.friction + cut_.drag * speed);
    for (int a = 0; a < D; ++a) sum.force[a] += size * v[a] / speed;
    sum.power += size * speed;
    for (int k = 0; k < carriers; ++k) {
      BladedNode<D> node{segment.slot[k], {}};
      for (int a = 0; a < D; ++a) node.force[a] = segment.weight[k] * size * v[a] / speed;
      body.bladed[&body.block_of(node.slot) - body.blocks.data()].push_back(node);
    }
  }
}

template class BladeResistance<double, 2>;
template class BladeResistance<double, 3>;
template class BladeResistance<float, 2>;
template class BladeResistance<float, 3>;
template TissueMap<2>::TissueMap(const Body<double, 2>&, InsideTest<2>);
template TissueMap<3>::TissueMap(const Body<double, 3>&, InsideTest<3>);
template TissueMap<2>::TissueMap(const Body<float, 2>&, InsideTest<2>);
template TissueMap<3>::TissueMap(const Body<float, 3>&, InsideTest<3>);

}  // namespace pliant::point_based
