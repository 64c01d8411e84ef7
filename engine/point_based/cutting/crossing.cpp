#include "engine/point_based/cutting/crossing.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/blocks/box.hpp"
#include "engine/lattice/column.hpp"

namespace pliant::point_based {
namespace {

/// Products of lengths below this share of their size count as zero.
constexpr double rounding = 1e-11;

double cross(const Column<2>& a, const Column<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The normal of a piece. Its length is that of the segment, or twice the area of the triangle.
Column<2> normal(const std::array<MaterialPoint<2>, 2>& piece) {
  const Column<2> along = column<2>(piece[1]) - column<2>(piece[0]);
  return {-along[1], along[0]};
}
Column<3> normal(const std::array<MaterialPoint<3>, 3>& piece) {
  const Column<3> a = column<3>(piece[0]);
  return (column<3>(piece[1]) - a).cross(column<3>(piece[2]) - a);
}

/// The normal whose first non-zero component is positive, for either orientation of the piece.
template <int D>
Column<D> upward_normal(const std::array<MaterialPoint<D>, D>& piece) {
  Column<D> n = normal(piece);
  const double slack = rounding * n.norm();
  for (int a = 0; a < D; ++a) {
    if (std::abs(n[a]) <= slack) continue;
    if (n[a] < 0) n = -n;
    break;
  }
  return n;
}

/// Whether the line from `p` along `d` meets the piece, including its boundary.
bool meets(const Column<2>& p, const Column<2>& d, const std::array<MaterialPoint<2>, 2>& piece) {
  const Column<2> a = column<2>(piece[0]) - p, b = column<2>(piece[1]) - p;
  const double slack = rounding * d.norm() * (b - a).norm();
  const double left = cross(d, a), right = cross(d, b);
  return (left >= -slack && right <= slack) || (left <= slack && right >= -slack);
}
bool meets(const Column<3>& p, const Column<3>& d, const std::array<MaterialPoint<3>, 3>& piece) {
  const Column<3> corners[] = {column<3>(piece[0]) - p, column<3>(piece[1]) - p,
                               column<3>(piece[2]) - p};
  double least = 0, largest = 0;
  for (int k = 0; k < 3; ++k) {
    const Column<3>&a = corners[k], &b = corners[(k + 1) % 3];
    const double slack = rounding * d.norm() * (b - a).norm() * std::max(a.norm(), b.norm());
    const double volume = d.dot(a.cross(b));
    if (volume > slack) largest = std::max(largest, volume);
    if (volume < -slack) least = std::min(least, volume);
  }
  return least == 0 || largest == 0;
}

/// The point of a segment nearest to the origin.
template <int D>
Column<D> nearest_on_segment(const Column<D>& a, const Column<D>& b) {
  const Column<D> along = b - a;
  const double square = along.squaredNorm();
  if (square == 0) return a;
  return a + std::clamp(-a.dot(along) / square, 0., 1.) * along;
}

}  // namespace

template <int D>
PieceCrossing<D>::PieceCrossing(const std::array<MaterialPoint<D>, D>& piece) : piece_(piece) {
  const Column<D> n = upward_normal<D>(piece);
  Eigen::Map<Column<D>>(normal_.data()) = n;
  slack_ = rounding * n.norm();
}

template <int D>
std::optional<MaterialPoint<D>> PieceCrossing<D>::operator()(const MaterialPoint<D>& p,
                                                             const MaterialPoint<D>& q) const {
  const Column<D> start = column<D>(p), along = column<D>(q) - start;
  const Column<D> to_start = start - column<D>(piece_[0]), to_end = to_start + along;
  const Column<D> n = column<D>(normal_);
  const double from = n.dot(to_start), to = n.dot(to_end);
  // Most bonds are far on one side. The sum of components is an upper bound on the length.
  const double ample = 2 * slack_ * (along.template lpNorm<1>() + to_start.template lpNorm<1>());
  if ((from > ample && to > ample) || (from < -ample && to < -ample)) return {};
  const double slack = slack_ * (along.norm() + to_start.norm());
  const bool starts_above = from >= -slack, ends_above = to >= -slack;
  if (starts_above == ends_above || from == to || !meets(start, along, piece_)) return {};
  MaterialPoint<D> found;
  Eigen::Map<Column<D>>(found.data()) = start + std::clamp(from / (from - to), 0., 1.) * along;
  return found;
}

template <int D>
double distance_to_segment(const MaterialPoint<D>& x, const MaterialPoint<D>& a,
                           const MaterialPoint<D>& b) {
  const Column<D> origin = column<D>(x);
  return nearest_on_segment<D>(column<D>(a) - origin, column<D>(b) - origin).norm();
}

template <int D>
PieceDistance<D> distance_to_piece(const MaterialPoint<D>& x,
                                   const std::array<MaterialPoint<D>, D>& piece) {
  const Column<D> n = normal(piece).normalized(), origin = column<D>(x);
  PieceDistance<D> found{0, n.dot(origin - column<D>(piece[0]))};
  if constexpr (D == 2) {
    found.distance = distance_to_segment<2>(x, piece[0], piece[1]);
  } else {
    bool is_over = true;  // whether the foot is inside the triangle
    for (int k = 0; k < 3; ++k) {
      const Column<3> a = column<3>(piece[k]), b = column<3>(piece[(k + 1) % 3]);
      is_over = is_over && n.dot((b - a).cross(origin - a)) >= 0;
    }
    found.distance = std::abs(found.across);
    if (!is_over) {
      found.distance = distance_to_segment<3>(x, piece[0], piece[1]);
      found.distance = std::min(found.distance, distance_to_segment<3>(x, piece[1], piece[2]));
      found.distance = std::min(found.distance, distance_to_segment<3>(x, piece[2], piece[0]));
    }
  }
  return found;
}

template <int D>
std::optional<MaterialPoint<D>> first_crossing(const MaterialPoint<D>& from,
                                               const MaterialPoint<D>& to,
                                               std::span<const CutSurface<D>> cuts) {
  Box<D> way;
  way.grow(from);
  way.grow(to);
  std::optional<MaterialPoint<D>> first;
  double least = (column<D>(to) - column<D>(from)).squaredNorm();
  for (const CutSurface<D>& cut : cuts) {
    for (std::size_t p = 0; p < cut.pieces().size(); ++p) {
      const auto corners = cut.corners(p);
      Box<D> box;
      for (const MaterialPoint<D>& corner : corners) box.grow(corner);
      if (squared_gap(box, way) > 0) continue;
      const auto place = crossing<D>(from, to, corners);
      if (!place) continue;
      const double square = (column<D>(*place) - column<D>(from)).squaredNorm();
      if (square >= least) continue;
      least = square;
      first = place;
    }
  }
  return first;
}

template class PieceCrossing<2>;
template class PieceCrossing<3>;
template double distance_to_segment<2>(const MaterialPoint<2>&, const MaterialPoint<2>&,
                                       const MaterialPoint<2>&);
template double distance_to_segment<3>(const MaterialPoint<3>&, const MaterialPoint<3>&,
                                       const MaterialPoint<3>&);
template std::optional<MaterialPoint<2>> first_crossing<2>(const MaterialPoint<2>&,
                                                           const MaterialPoint<2>&,
                                                           std::span<const CutSurface<2>>);
template std::optional<MaterialPoint<3>> first_crossing<3>(const MaterialPoint<3>&,
                                                           const MaterialPoint<3>&,
                                                           std::span<const CutSurface<3>>);
template PieceDistance<2> distance_to_piece<2>(const MaterialPoint<2>&,
                                               const std::array<MaterialPoint<2>, 2>&);
template PieceDistance<3> distance_to_piece<3>(const MaterialPoint<3>&,
                                               const std::array<MaterialPoint<3>, 3>&);

}  // namespace pliant::point_based
