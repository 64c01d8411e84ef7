#include "engine/point_based/cutting/cut_front.hpp"

#include <algorithm>
#include <cmath>

#include "engine/point_based/cutting/crossing.hpp"
#include "engine/point_based/cutting/subdivide.hpp"

namespace pliant::point_based {
namespace {

constexpr double slack = 1 + 1e-6;  // of squared distances that are compared with a bound

template <int D>
double squared_distance(const MaterialPoint<D>& a, const MaterialPoint<D>& b) {
  double sum = 0;
  for (int i = 0; i < D; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

}  // namespace

double share_before_front(double distance, double size) {
  const double s = std::clamp(distance / (reach_of_front * size), 0., 1.);
  return 1 - s * s * (3 - 2 * s);
}

template <int D>
void CutFront<D>::add_parts(const CutSurface<D>& cut, const typename CutSurface<D>::Edge& edge,
                            std::vector<Part>& parts) const {
  const MaterialPoint<D>&a = cut.points()[edge[0]], &b = cut.points()[edge[1]];
  const double length = std::sqrt(squared_distance<D>(a, b));
  const int count = std::max(1, static_cast<int>(std::ceil(length / length_)));
  for (int k = 0; k < count; ++k) {
    const double share = 1. / count;
    const Part part{between<D>(a, b, k * share), between<D>(a, b, (k + 1) * share),
                    between<D>(a, b, (k + 0.5) * share)};
    if (is_inside_(part.middle)) parts.push_back(part);
  }
}

template <int D>
bool CutFront<D>::has_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                             const Part& part) const {
  const double near = length_ / 4;
  Box<D> place;
  place.grow(part.middle);
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    for (std::size_t p = from[c]; c != which && p < cuts[c].pieces().size(); ++p) {
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
void CutFront<D>::remove_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                                std::vector<Part>& parts) {
  std::erase_if(parts, [&](const Part& part) {
    if (!has_joined(cuts, which, from, part)) return false;
    changed_.grow(part.from);
    changed_.grow(part.to);
    return true;
  });
}

template <int D>
void CutFront<D>::add_to_changed(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    changed_.grow(part.from);
    changed_.grow(part.to);
  }
}

// Rims that have been compared with a piece of another cut need not be compared with it again.
template <int D>
void CutFront<D>::update(Cuts cuts, std::size_t which) {
  const CutSurface<D>& cut = cuts[which];
  tested_.resize(cuts.size(), 0);
  remove_joined(cuts, which, tested_, rim_);
  const std::vector<std::size_t> all(cuts.size(), 0);
  if (cut.stations() > std::max(stations_, 1)) {
    std::vector<Part> added;
    for (const auto& edge : cut.rim(std::max(stations_ - 1, 0))) add_parts(cut, edge, added);
    add_to_changed(added);
    remove_joined(cuts, which, all, added);
    rim_.insert(rim_.end(), added.begin(), added.end());
    add_to_changed(leading_);
    leading_.clear();
    for (const auto& edge : cut.leading_edge()) add_parts(cut, edge, leading_);
    add_to_changed(leading_);
    remove_joined(cuts, which, all, leading_);
    stations_ = cut.stations();
  } else {
    remove_joined(cuts, which, tested_, leading_);
  }
  for (std::size_t c = 0; c < cuts.size(); ++c) tested_[c] = cuts[c].pieces().size();
}

template <int D>
double CutFront<D>::distance(const MaterialPoint<D>& x, double most) const {
  double least = most;
  for (const std::vector<Part>* parts : {&rim_, &leading_}) {
    for (const Part& part : *parts) {
      // No point of a part is farther than half of the length from its middle.
      const double reach = least + length_ / 2;
      if (squared_distance<D>(x, part.middle) > slack * reach * reach) continue;
      least = std::min(least, distance_to_segment<D>(x, part.from, part.to));
    }
  }
  return least;
}

template class CutFront<2>;
template class CutFront<3>;

}  // namespace pliant::point_based
