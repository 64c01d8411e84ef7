#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

/// Decompositions of small dense matrices. Eigen's templates take seconds to compile for each size,
/// so they are instantiated only here, and once for all sizes where speed matters little.
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
Eigen::Matrix<double, N, 1> eigenvalues(const Eigen::Matrix<double, N, N>& symmetric);  // N = 2, 3

/// A matrix of up to N rows and columns, which is on the stack.
template <int N>
using MatrixOfAtMost = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, N, N>;

double largest_eigenvalue(const MatrixOfAtMost<12>& symmetric);

/// The Moore-Penrose pseudo-inverse: of all X that minimise |A X - 1|, the smallest. Pivots below
/// `threshold` times the largest one count as 0.
MatrixOfAtMost<4> pseudo_inverse(const MatrixOfAtMost<4>& a, double threshold);
template <int N>
Eigen::Matrix<double, N, N> pseudo_inverse(
    const Eigen::Matrix<double, N, N>& a,
    double threshold = N * std::numeric_limits<double>::epsilon()) {
  return pseudo_inverse(MatrixOfAtMost<4>(a), threshold);
}

/// X where A X = B, of a symmetric and positive definite A. None where A is singular: where a pivot
/// is not above `threshold` times the largest.
std::optional<MatrixOfAtMost<10>> solve_definite(const MatrixOfAtMost<10>& a,
                                                 const MatrixOfAtMost<10>& b, double threshold);

}  // namespace pliant
