#pragma once

#include <Eigen/Core>
#include <limits>

/// Decompositions of small dense matrices. Eigen's templates take seconds to compile for each size,
/// so they are instantiated only here.
namespace pliant {

/// Eigenvalues and eigenvectors of a symmetric matrix.
template <int N>
struct Eigensystem {
  Eigen::Matrix<double, N, 1> values;   ///< in ascending order
  Eigen::Matrix<double, N, N> vectors;  ///< of length 1, in columns
};

template <int N>
Eigensystem<N> eigensystem(const Eigen::Matrix<double, N, N>& symmetric);  // N = 2, 3

/// Eigenvalues of a symmetric matrix, in ascending order.
template <int N>
Eigen::Matrix<double, N, 1> eigenvalues(
    const Eigen::Matrix<double, N, N>& symmetric);  // N = 2, 3, 6, 12

/// The Moore-Penrose pseudo-inverse: of all X that minimise |A X - 1|, the smallest. Pivots below
/// `threshold` times the largest one count as 0.
template <int N>
Eigen::Matrix<double, N, N> pseudo_inverse(
    const Eigen::Matrix<double, N, N>& a,
    double threshold = N * std::numeric_limits<double>::epsilon());  // N = 2, 3, 4

}  // namespace pliant
