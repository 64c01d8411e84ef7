#include "engine/method/decompositions.hpp"

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

template <int N>
Eigen::Matrix<double, N, N> pseudo_inverse(const Eigen::Matrix<double, N, N>& a, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, N, N>> solver;
  solver.setThreshold(threshold);
  solver.compute(a);
  return solver.pseudoInverse();
}

template Eigensystem<2> eigensystem<2>(const Eigen::Matrix2d&);
template Eigensystem<3> eigensystem<3>(const Eigen::Matrix3d&);
template Eigen::Vector2d eigenvalues<2>(const Eigen::Matrix2d&);
template Eigen::Vector3d eigenvalues<3>(const Eigen::Matrix3d&);
template Eigen::Matrix<double, 6, 1> eigenvalues<6>(const Eigen::Matrix<double, 6, 6>&);
template Eigen::Matrix<double, 12, 1> eigenvalues<12>(const Eigen::Matrix<double, 12, 12>&);
template Eigen::Matrix2d pseudo_inverse<2>(const Eigen::Matrix2d&, double);
template Eigen::Matrix3d pseudo_inverse<3>(const Eigen::Matrix3d&, double);
template Eigen::Matrix4d pseudo_inverse<4>(const Eigen::Matrix4d&, double);

}  // namespace pliant
