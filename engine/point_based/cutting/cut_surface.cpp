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
auto CutSurface<D>::edge_of(std::int32_t station) const -> std::vector<Edge> {
  const std::int32_t first = station * points_per_station_;
  if constexpr (D == 2) return {{first, first}};
  std::vector<Edge> edges;
  edges.reserve(points_per_station_);
  for (std::int32_t k = 0; k + 1 < points_per_station_; ++k) {
    edges.push_back({first + k, first + k + 1});
  }
  return edges;
}

template <int D>
auto CutSurface<D>::rim(std::int32_t station) const -> std::vector<Boundary> {
  std::vector<Boundary> edges;
  if (stations() < 2) return edges;
  if (station == 0) {
    const std::vector<Edge> first = edge_of(0), second = edge_of(1);
    for (std::size_t k = 0; k < first.size(); ++k) edges.push_back({first[k], second[k]});
  }
  if constexpr (D == 3) {
    const std::int32_t count = points_per_station_;
    edges.reserve(edges.size() + 2 * static_cast<std::size_t>(stations() - 1 - station));
    for (std::int32_t s = station; s + 1 < stations(); ++s) {
      const std::int32_t start = s * count, end = start + count;
      edges.push_back({{start, end}, {start + 1, end + 1}});
      edges.push_back({{start + count - 1, end + count - 1}, {start + count - 2, end + count - 2}});
    }
  }
  return edges;
}

template class CutSurface<2>;
template class CutSurface<3>;

}  // namespace pliant::point_based
