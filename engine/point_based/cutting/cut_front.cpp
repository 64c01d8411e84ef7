#include "engine/point_based/cutting/cut_front.hpp"

#include <algorithm>
#include <cmath>

#include "engine/blocks/box_tree.hpp"
#include "engine/point_based/cutting/crossing.hpp"

namespace pliant::point_based {
namespace {

constexpr double slack = 1 + 1e-6;  // of squared distances that are compared with a bound

template <int D>
MaterialPoint<D> between(const MaterialPoint<D>& a, const MaterialPoint<D>& b, double share) {
  MaterialPoint<D> x;
  for (int i = 0; i < D; ++i) x[i] = a[i] + share * (b[i] - a[i]);
  return x;
}

template <int D>
double squared_distance(const MaterialPoint<D>& a, const MaterialPoint<D>& b) {
  double sum = 0;
  for (int i = 0; i < D; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

}  // namespace

template <int D>
auto CutFront<D>::parts_inside(const CutSurface<D>& cut, const std::array<std::int32_t, 2>& edge)
    -> const std::vector<Part>& {
  const auto [found, is_new] = inside_.try_emplace(edge);
  if (!is_new) return found->second;
  const MaterialPoint<D>&a = cut.points()[edge[0]], &b = cut.points()[edge[1]];
  const double length = std::sqrt(squared_distance<D>(a, b));
  const int count = std::max(1, static_cast<int>(std::ceil(length / length_)));
  for (int k = 0; k < count; ++k) {
    const double share = 1. / count;
    const Part part{between<D>(a, b, k * share), between<D>(a, b, (k + 1) * share),
                    between<D>(a, b, (k + 0.5) * share)};
    if (is_inside_(part.middle)) found->second.push_back(part);
  }
  return found->second;
}

template <int D>
bool CutFront<D>::has_joined(std::span<const CutSurface<D>> cuts, std::size_t which,
                             const Part& part) const {
  const double near = length_ / 4;
  Box<D> place;
  place.grow(part.middle);
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    for (std::size_t p = 0; c != which && p < cuts[c].pieces().size(); ++p) {
      const auto corners = cuts[c].corners(p);
      Box<D> box;
      for (const MaterialPoint<D>& corner : corners) box.grow(corner);
      // Most pieces are far away; the slack is for what distance_to_piece rounds.
      if (squared_gap(box, place) > slack * near * near) continue;
      if (distance_to_piece<D>(part.middle, corners).distance < near) return true;
    }
  }
  return false;
}

template <int D>
void CutFront<D>::update(std::span<const CutSurface<D>> cuts, std::size_t which) {
  front_.clear();
  for (const auto& edge : cuts[which].boundary()) {
    for (const Part& part : parts_inside(cuts[which], edge)) {
      if (!has_joined(cuts, which, part)) front_.push_back(part);
    }
  }
}

template <int D>
double CutFront<D>::distance(const MaterialPoint<D>& x, double most) const {
  double least = most;
  for (const Part& part : front_) {
    // No point of a part is farther than half of the length from its middle.
    const double reach = least + length_ / 2;
    if (squared_distance<D>(x, part.middle) > slack * reach * reach) continue;
    least = std::min(least, distance_to_segment<D>(x, part.from, part.to));
  }
  return least;
}

template class CutFront<2>;
template class CutFront<3>;

}  // namespace pliant::point_based
