#include "engine/point_based/bonds/node_operator.hpp"

#include <Eigen/LU>

#include "engine/method/decompositions.hpp"

namespace pliant::point_based {

namespace {

constexpr double smallest_eigenvalue = 1e-4;  // relative to the largest

}  // namespace

double bond_weight(double relative_distance) {
  const double t = 1 - relative_distance * relative_distance;
  return t > 0 ? t * t * t : 0;
}

template <int D>
NodeOperator<D> node_operator(std::span<const Point<D>> bonds, std::span<const double> weights) {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;
  Matrix a = Matrix::Zero();
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    const Eigen::Map<const Vector> x(bonds[k].data());
    a += weights[k] * x * x.transpose();
  }
  NodeOperator<D> made;
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) made.moment[kernels::symmetric_index<D>(i, j)] = a(i, j);
  }
  const Eigensystem<D> axes = eigensystem<D>(a);
  const double largest = axes.values[D - 1];
  Matrix inverse = Matrix::Zero();
  for (int e = D - 1; e >= 0; --e) {
    const double value = axes.values[e];
    if (!(value > smallest_eigenvalue * largest)) break;
    const Vector q = axes.vectors.col(e);
    inverse += q * q.transpose() / value;
    for (int i = 0; i < D; ++i) made.direction[made.rank][i] = q[i];
    ++made.rank;
  }
  if (made.rank == D) inverse = a.inverse();
  made.gradient.resize(bonds.size());
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    const Eigen::Map<const Vector> x(bonds[k].data());
    Eigen::Map<Vector>(made.gradient[k].data()) = weights[k] * (inverse * x);
  }
  return made;
}

template NodeOperator<2> node_operator<2>(std::span<const Point<2>>, std::span<const double>);
template NodeOperator<3> node_operator<3>(std::span<const Point<3>>, std::span<const double>);

}  // namespace pliant::point_based
