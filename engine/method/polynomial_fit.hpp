#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "engine/lattice/lattice.hpp"
#include "engine/method/decompositions.hpp"

namespace pliant {

/// Weighted least-squares fit of `V` fields by polynomials of degree 1 or 2 in the distance from a
/// point.
template <int D, int V, int degree>
class PolynomialFit {
 public:
  /// Adds the values at one place; `r` is the vector from the point to it, in any unit.
  void add(const Point<D>& r, double weight, const std::array<double, V>& values) {
    Eigen::Matrix<double, terms, 1> q;
    q[0] = 1;
    for (int a = 0; a < D; ++a) q[a + 1] = r[a];
    if constexpr (degree == 2) {
      for (int a = 0, k = D + 1; a < D; ++a) {
        for (int b = a; b < D; ++b) q[k++] = r[a] * r[b];
      }
    }
    normal_ += weight * q * q.transpose();
    for (int v = 0; v < V; ++v) right_.col(v) += weight * values[v] * q;
  }

  /// Returns false where the values do not determine the polynomials.
  bool solve() {
    constexpr double singular = 1e-9;
    static_assert(terms <= 10 && V < 10, "the largest system of solve_definite");
    Eigen::Matrix<double, terms, V + 1> right;
    right << right_, Eigen::Matrix<double, terms, 1>::Unit(0);
    const std::optional<MatrixOfAtMost<10>> solved = solve_definite(normal_, right, singular);
    if (!solved) return false;
    right_ = solved->template leftCols<V>();
    amplification_ = (*solved)(0, V) * normal_(0, 0);
    return true;
  }

  /// Value of a field at the point, after `solve`.
  double value(int field) const { return right_(0, field); }
  /// Slope of a field along an axis [1/unit of r], after `solve`.
  double slope(int field, int axis) const { return right_(axis + 1, field); }
  /// Variance of the value over that of a weighted mean, for equal random errors; large if the
  /// point is outside the places of the values. After `solve`.
  double amplification() const { return amplification_; }

 private:
  static constexpr int terms = degree == 1 ? D + 1 : (D + 1) * (D + 2) / 2;

  Eigen::Matrix<double, terms, terms> normal_ = Eigen::Matrix<double, terms, terms>::Zero();
  Eigen::Matrix<double, terms, V> right_ = Eigen::Matrix<double, terms, V>::Zero();
  double amplification_ = 0;
};

template <int D, int V>
using LinearFit = PolynomialFit<D, V, 1>;
template <int D, int V>
using QuadraticFit = PolynomialFit<D, V, 2>;

}  // namespace pliant
