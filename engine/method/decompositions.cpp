#include "engine/method/decompositions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace pliant {

template <int N>
Eigensystem<N> eigensystem(const Eigen::Matrix<double, N, N>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

template <int N>
Eigen::Matrix<double, N, 1> eigenvalues(const Eigen::Matrix<double, N, N>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(symmetric,
                                                                          Eigen::EigenvaluesOnly);
  return solver.eigenvalues();
}

double largest_eigenvalue(const MatrixOfAtMost<12>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixOfAtMost<12>> solver(symmetric, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[symmetric.rows() - 1];
}

MatrixOfAtMost<4> pseudo_inverse(const MatrixOfAtMost<4>& a, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<MatrixOfAtMost<4>> solver;
  solver.setThreshold(threshold);
  solver.compute(a);
  return solver.pseudoInverse();
}

std::optional<MatrixOfAtMost<10>> solve_definite(const MatrixOfAtMost<10>& a,
                                                 const MatrixOfAtMost<10>& b, double threshold) {
  const Eigen::LDLT<MatrixOfAtMost<10>> factors(a);
  const auto pivots = factors.vectorD();
  if (!(pivots.minCoeff() > threshold * pivots.maxCoeff())) return std::nullopt;
  return factors.solve(b);
}

template Eigensystem<2> eigensystem<2>(const Eigen::Matrix2d&);
template Eigensystem<3> eigensystem<3>(const Eigen::Matrix3d&);
template Eigen::Vector2d eigenvalues<2>(const Eigen::Matrix2d&);
template Eigen::Vector3d eigenvalues<3>(const Eigen::Matrix3d&);

}  // namespace pliant
