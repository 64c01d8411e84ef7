#include "engine/point_based/cutting/cut_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/point_based/cutting/crossing.hpp"

namespace pliant::point_based {
namespace {

template <int D>
MaterialPoint<D> between(const MaterialPoint<D>& a, const MaterialPoint<D>& b, double share) {
  MaterialPoint<D> x;
  for (int i = 0; i < D; ++i) x[i] = a[i] + share * (b[i] - a[i]);
  return x;
}

}  // namespace

template <int D>
auto CutFront<D>::parts_inside(const CutSurface<D>& cut, const std::array<std::int32_t, 2>& edge)
    -> const std::vector<Part>& {
  const auto [found, is_new] = inside_.try_emplace(edge);
  if (!is_new) return found->second;
  const MaterialPoint<D>&a = cut.points()[edge[0]], &b = cut.points()[edge[1]];
  double square = 0;
  for (int i = 0; i < D; ++i) square += (b[i] - a[i]) * (b[i] - a[i]);
  const int count = std::max(1, static_cast<int>(std::ceil(std::sqrt(square) / length_)));
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
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    for (std::size_t p = 0; c != which && p < cuts[c].pieces().size(); ++p) {
      if (distance_to_piece<D>(part.middle, cuts[c].corners(p)).distance < length_ / 4) return true;
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
double CutFront<D>::distance(const MaterialPoint<D>& x) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Part& part : front_) {
    least = std::min(least, distance_to_segment<D>(x, part.from, part.to));
  }
  return least;
}

template class CutFront<2>;
template class CutFront<3>;

}  // namespace pliant::point_based
