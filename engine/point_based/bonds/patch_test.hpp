#pragma once

#include <limits>
#include <vector>

#include "engine/point_based/bonds/patch_forces.hpp"

/// Weights with which moving least squares pass the patch test.
///
/// A uniform stress P exerts P r_i on node i, apart from the load on its share of the surface,
/// where r_i = sum_j (V_j g_ji - V_i g_ij) - a_i. There are many more bonds than components of r.
/// Of all changes of the weights that make r vanish, the smallest is computed. With c = ln of the
/// factors and J = dr/dc, each step solves (J J^T + a I) y = -r by conjugate gradients and adds J^T
/// y to c; a = 0 makes it a Gauss-Newton step. Gradients still follow from the weights: they stay
/// exact for linear fields, and a step costs the same.
namespace pliant::point_based {

/// Steps that reduce the forces of a uniform stress on nodes with weighted bonds.
template <int D>
class PatchTest {
 public:
  /// No weight changes by more than the factor `most_change`, or its inverse. Steps that are far
  /// too long become those of Levenberg and Marquardt, with `regularisation` times the mean of the
  /// diagonal. Later plain steps are rarely shorter: they are tried at growing intervals only.
  PatchTest(WeightedNodes<D>& nodes, scheduler::Workers& workers,
            double most_change = std::numeric_limits<double>::infinity(),
            double regularisation = 0);

  /// The largest force on a node that no wall bears, over the stress times V^((D-1)/D).
  double worst() const;

  /// One step; its equations are solved to `tolerance`. A step that increases the sum of the
  /// squares is halved. Returns whether any decreases it; if none does, the weights stay.
  bool improve(double tolerance, int most_iterations);

 private:
  using Vectors = typename PatchForces<D>::Vectors;

  struct Change {
    double step = 0;   ///< of ln c
    double log = 0;    ///< ln c
    double start = 0;  ///< ln c at the start of a step
  };

  double square() const;
  double mean_of_diagonal() const;
  double find_step(double tolerance, int most_iterations);
  void find_change(double tolerance, int most_iterations, double added);
  void move(double share);
  Vectors solve(double tolerance, int most_iterations, double added);

  WeightedNodes<D>& nodes_;
  PatchForces<D> forces_;
  double most_change_;  ///< of ln c
  double regularisation_;
  int pause_ = 0;  ///< steps from one trial of a plain step to the next
  int steps_until_trial_ = 0;
  std::vector<Change> changes_;  ///< [bond]
};

}  // namespace pliant::point_based
