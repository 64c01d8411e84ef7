#include "engine/point_based/cutting/cut_front.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cutting/crossing.hpp"
#include "engine/point_based/cutting/subdivide.hpp"

namespace pliant::point_based {
namespace {

constexpr double slack = 1 + 1e-6;   // in comparisons of squared distances with a bound
constexpr double no_length = 1e-9;   // of the length of parts
constexpr double near_other = 0.25;  // of the length of parts
constexpr double around_own = 0.5;   // (PB.36), of the length of parts
constexpr double near_own = 0.2;
constexpr double least_reversal = 0.9659;  // cosine of 15 degrees

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
void CutFront<D>::add_parts(const CutSurface<D>& cut, const Edge& edge, const Edge& from,
                            std::vector<Part>& parts) const {
  const MaterialPoint<D>&a = cut.points()[edge[0]], &b = cut.points()[edge[1]];
  const MaterialPoint<D>&a_from = cut.points()[from[0]], &b_from = cut.points()[from[1]];
  const double length = std::sqrt(squared_distance<D>(a, b));
  // An end of the blade about which it turns has no path.
  if (D == 3 && length <= no_length * length_) return;
  const int count = std::max(1, static_cast<int>(std::ceil(length / length_)));
  for (int k = 0; k < count; ++k) {
    const double share = 1. / count;
    Part part{between<D>(a, b, k * share),
              between<D>(a, b, (k + 1) * share),
              between<D>(a, b, (k + 0.5) * share),
              {}};
    if (!is_inside_(part.middle)) continue;
    const MaterialPoint<D> behind = between<D>(a_from, b_from, (k + 0.5) * share);
    Column<D> outward = column<D>(part.middle) - column<D>(behind);
    const Column<D> along = (column<D>(b) - column<D>(a)).normalized();
    outward -= outward.dot(along) * along;
    Eigen::Map<Column<D>>(part.outward.data()) = outward.normalized();
    parts.push_back(part);
  }
}

template <int D>
auto CutFront<D>::turned_back(const CutSurface<D>& cut, std::int32_t station) const
    -> std::vector<Part> {
  std::vector<Part> before, after;
  const auto last = cut.edge_of(station - 1), turn = cut.edge_of(station);
  const auto next = cut.edge_of(station + 1);
  for (std::size_t k = 0; k < turn.size(); ++k) {
    add_parts(cut, turn[k], last[k], before);
    add_parts(cut, turn[k], next[k], after);
  }
  std::vector<Part> turned;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double cosine = column<D>(before[k].outward).dot(column<D>(after[k].outward));
    if (cosine > least_reversal) turned.push_back(before[k]);
  }
  return turned;
}

// Tests seven of eight points around the part, normal to it; the eighth is on the piece that it
// bounds.
template <int D>
bool CutFront<D>::meets_own(const Part& part, const std::array<MaterialPoint<D>, D>& piece) const {
  const Column<D> outward = column<D>(part.outward);
  Column<D> across;
  if constexpr (D == 2) {
    across = {-outward[1], outward[0]};
  } else {
    across = (column<3>(part.to) - column<3>(part.from)).normalized().cross(outward);
  }
  if (across.isZero()) return false;
  for (int k = -3; k <= 3; ++k) {
    const double angle = k * std::numbers::pi / 4;
    MaterialPoint<D> x;
    Eigen::Map<Column<D>>(x.data()) =
        column<D>(part.middle) +
        around_own * length_ * (std::cos(angle) * outward + std::sin(angle) * across);
    if (distance_to_piece<D>(x, piece).distance < near_own * length_) return true;
  }
  return false;
}

template <int D>
bool CutFront<D>::has_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                             const Part& part) const {
  Box<D> place;
  place.grow(part.middle);
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    const double near = (c == which ? around_own + near_own : near_other) * length_;
    for (std::size_t p = from[c]; p < cuts[c].pieces().size(); ++p) {
      const auto corners = cuts[c].corners(p);
      Box<D> box;
      for (const MaterialPoint<D>& corner : corners) box.grow(corner);
      // Most pieces are far away; the slack covers rounding in distance_to_piece.
      if (squared_gap(box, place) > slack * near * near) continue;
      if (c == which ? meets_own(part, corners)
                     : distance_to_piece<D>(part.middle, corners).distance < near) {
        return true;
      }
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

// Rims are compared with each piece of a cut only once.
template <int D>
void CutFront<D>::update(Cuts cuts, std::size_t which) {
  const CutSurface<D>& cut = cuts[which];
  tested_.resize(cuts.size(), 0);
  remove_joined(cuts, which, tested_, rim_);
  const std::vector<std::size_t> all(cuts.size(), 0);
  if (cut.stations() > std::max(stations_, 1)) {
    const std::int32_t last = cut.stations() - 1;
    std::vector<Part> added;
    for (std::int32_t s = std::max(stations_ - 1, 1); s < last; ++s) {
      const std::vector<Part> turned = turned_back(cut, s);
      added.insert(added.end(), turned.begin(), turned.end());
    }
    for (const auto& boundary : cut.rim(std::max(stations_ - 1, 0))) {
      add_parts(cut, boundary.edge, boundary.opposite, added);
    }
    add_to_changed(added);
    remove_joined(cuts, which, all, added);
    rim_.insert(rim_.end(), added.begin(), added.end());
    add_to_changed(leading_);
    leading_.clear();
    const auto edges = cut.edge_of(last), before = cut.edge_of(last - 1);
    for (std::size_t k = 0; k < edges.size(); ++k) add_parts(cut, edges[k], before[k], leading_);
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
      // Points of a part are at most half of the length from its middle.
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
