#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pliant::point_based {

/// A place in the undeformed body [m].
template <int D>
using MaterialPoint = std::array<double, D>;

/// A cut: the surface that a blade has swept. It consists of material points and so moves with the
/// tissue. The blade has moved from one station to the next. A station is a point in 2D, and in 3D
/// a polyline of a fixed number of points along the blade's edge.
///
///     2D    o----o----o        3D    o----o----o     the pieces between two stations are
///           0    1    2              |  / |  / |     segments (2D) or pairs of triangles (3D)
///          stations                  | /  | /  |
///                                    o----o----o
template <int D>
class CutSurface {
 public:
  using Point = MaterialPoint<D>;
  using Piece = std::array<std::int32_t, D>;  ///< corners, as numbers of points

  /// Sweeps from the last station to a new one. All stations have the same number of points: one in
  /// 2D, two or more in 3D.
  void add_station(const std::vector<Point>& station);

  const std::vector<Point>& points() const { return points_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  std::int32_t stations() const;
  std::int32_t points_per_station() const { return points_per_station_; }
  const Point& point(std::int32_t station, std::int32_t k) const {
    return points_[station * points_per_station_ + k];
  }
  std::array<Point, D> corners(std::size_t piece) const;

  using Edge = std::array<std::int32_t, 2>;  ///< numbers of points; in 2D both are equal
  /// The edge of a station, where the blade was. The cut grows from the edge of its last station.
  std::vector<Edge> edge_of(std::int32_t station) const;
  /// An edge of the boundary, and the opposite edge of the pieces that it bounds.
  struct Boundary {
    Edge edge, opposite;
  };
  /// The boundary from `station` on, except the last station: the paths of the blade's ends (3D),
  /// and the edge of station 0 if `station` is 0.
  std::vector<Boundary> rim(std::int32_t station) const;

 private:
  std::vector<Point> points_;  ///< [station][point along the edge]
  std::vector<Piece> pieces_;
  std::int32_t points_per_station_ = 0;
};

extern template class CutSurface<2>;
extern template class CutSurface<3>;

}  // namespace pliant::point_based
