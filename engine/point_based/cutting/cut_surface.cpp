#include "engine/point_based/cutting/cut_surface.hpp"

#include <cassert>

namespace pliant::point_based {

template <int D>
void CutSurface<D>::add_station(const std::vector<Point>& station) {
  const auto count = static_cast<std::int32_t>(station.size());
  assert(points_.empty() || count == points_per_station_);
  assert(count >= D - 1);
  points_per_station_ = count;
  const auto before = static_cast<std::int32_t>(points_.size()) - count;
  points_.insert(points_.end(), station.begin(), station.end());
  if (before < 0) return;
  const std::int32_t after = before + count;
  if constexpr (D == 2) {
    pieces_.push_back({before, after});
  } else {
    for (std::int32_t k = 0; k + 1 < count; ++k) {
      pieces_.push_back({before + k, after + k, after + k + 1});
      pieces_.push_back({before + k, after + k + 1, before + k + 1});
    }
  }
}

template <int D>
std::int32_t CutSurface<D>::stations() const {
  if (points_.empty()) return 0;
  return static_cast<std::int32_t>(points_.size()) / points_per_station_;
}

template <int D>
std::array<MaterialPoint<D>, D> CutSurface<D>::corners(std::size_t piece) const {
  std::array<Point, D> corners;
  for (int k = 0; k < D; ++k) corners[k] = points_[pieces_[piece][k]];
  return corners;
}

template <int D>
std::vector<std::array<std::int32_t, 2>> CutSurface<D>::boundary() const {
  std::vector<std::array<std::int32_t, 2>> edges;
  if (pieces_.empty()) return edges;
  const std::int32_t count = points_per_station_;
  const std::int32_t last = static_cast<std::int32_t>(points_.size()) - count;
  if constexpr (D == 2) {
    edges = {{0, 0}, {last, last}};
  } else {
    edges.reserve(2 * (points_.size() / count + count));
    for (std::int32_t k = 0; k + 1 < count; ++k) {
      edges.push_back({k, k + 1});
      edges.push_back({last + k, last + k + 1});
    }
    for (std::int32_t start = 0; start < last; start += count) {
      edges.push_back({start, start + count});
      edges.push_back({start + count - 1, start + 2 * count - 1});
    }
  }
  return edges;
}

template class CutSurface<2>;
template class CutSurface<3>;

}  // namespace pliant::point_based
