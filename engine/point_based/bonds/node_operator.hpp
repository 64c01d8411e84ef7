#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/lattice/lattice.hpp"
#include "kernels/layout.hpp"

/// The moving-least-squares gradient of a node.
namespace pliant::point_based {

/// w of (PB.2); the argument is the distance over the support radius.
double bond_weight(double relative_distance);

/// The gradient operator (PB.3) of a node.
template <int D>
struct NodeOperator {
  std::array<double, kernels::symmetric_components<D>> moment = {};  ///< A [m^2]
  std::vector<Point<D>> gradient;  ///< [bond] g_ij [1/m], in the span of the bonds
  /// Eigenvectors of A, in descending order of eigenvalues; the first `rank` of them span the
  /// bonds.
  std::array<Point<D>, D> direction = {};
  int rank = 0;  ///< D unless the neighbours lie almost in a plane or on a line

  double trace() const {
    double sum = 0;
    for (int a = 0; a < D; ++a) sum += moment[kernels::symmetric_index<D>(a, a)];
    return sum;
  }
};

/// The operator of bonds X_ij [m] with weights w_ij, (PB.3). Directions with an eigenvalue below
/// 1e-4 of the largest are left out. A is never regularised: that would exert forces on a rotating
/// body.
template <int D>
NodeOperator<D> node_operator(std::span<const Point<D>> bonds, std::span<const double> weights);

extern template NodeOperator<2> node_operator<2>(std::span<const Point<2>>,
                                                 std::span<const double>);
extern template NodeOperator<3> node_operator<3>(std::span<const Point<3>>,
                                                 std::span<const double>);

}  // namespace pliant::point_based
