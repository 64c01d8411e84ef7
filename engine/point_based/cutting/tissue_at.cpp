#include "engine/point_based/cutting/tissue_at.hpp"

#include <Eigen/Dense>
#include <limits>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cutting/crossing.hpp"
#include "engine/point_based/forces/node_gradient.hpp"

namespace pliant::point_based {

namespace {

constexpr double least_volume_ratio = 0.05;

template <class T, int D>
std::int64_t nearest_node(const Body<T, D>& body, const Point<D>& x) {
  std::int64_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  body.for_each_node([&](std::int64_t slot) {
    double square = 0;
    for (int a = 0; a < D; ++a) {
      const double d = body.start[slot][a] + body.displacement[a][slot] - x[a];
      square += d * d;
    }
    if (square >= least) return;
    least = square;
    nearest = slot;
  });
  return nearest;
}

}  // namespace

template <class T, int D>
MaterialPoint<D> tissue_at(const Body<T, D>& body, std::span<const CutSurface<D>> cuts,
                           const Point<D>& x) {
  using Matrix = Eigen::Matrix<double, D, D, Eigen::RowMajor>;
  const std::int64_t slot = nearest_node<T, D>(body, x);
  const auto f = fitted_gradient(body, body.block_of(slot), slot);
  const Eigen::Map<const Matrix> gradient(f.data());
  Column<D> away = column<D>(x) - column<D>(body.position(slot));
  if (gradient.determinant() > least_volume_ratio) away = gradient.inverse() * away;
  MaterialPoint<D> place;
  Eigen::Map<Column<D>>(place.data()) = column<D>(body.start[slot]) + away;
  return first_crossing<D>(body.start[slot], place, cuts).value_or(place);
}

template MaterialPoint<2> tissue_at<double, 2>(const Body<double, 2>&,
                                               std::span<const CutSurface<2>>, const Point<2>&);
template MaterialPoint<3> tissue_at<double, 3>(const Body<double, 3>&,
                                               std::span<const CutSurface<3>>, const Point<3>&);
template MaterialPoint<2> tissue_at<float, 2>(const Body<float, 2>&, std::span<const CutSurface<2>>,
                                              const Point<2>&);
template MaterialPoint<3> tissue_at<float, 3>(const Body<float, 3>&, std::span<const CutSurface<3>>,
                                              const Point<3>&);

}  // namespace pliant::point_based
