#pragma once

#include <Eigen/Core>
#include <limits>

/// Decompositions of small dense matrices. Eigen's are templates that take a compiler seconds for
/// each size: they are instantiated here, once for all callers.
namespace pliant {

/// Of a symmetric matrix.
template <int N>
struct Eigensystem {
  Eigen::Matrix<double, N, 1> values;   ///< in ascending order
  Eigen::Matrix<double, N, N> vectors;  ///< of length 1, in columns
};

template <int N>
Eigensystem<N> eigensystem(const Eigen::Matrix<double, N, N>& symmetric);  // N = 2, 3

/// Of a symmetric matrix, in ascending order.
template <int N>
Eigen::Matrix<double, N, 1> eigenvalues(
    const Eigen::Matrix<double, N, N>& symmetric);  // N = 2, 3, 6, 12

/// Of the matrices X for which A X - 1 is least, the least one; pivots below `threshold` of the
/// largest one count as 0.
template <int N>
Eigen::Matrix<double, N, N> pseudo_inverse(
    const Eigen::Matrix<double, N, N>& a,
    double threshold = N * std::numeric_limits<double>::epsilon());  // N = 2, 3, 4

}  // namespace pliant
