#pragma once

#include "kernels/isa.hpp"
#include "kernels/point_based/arguments.hpp"

namespace pliant::kernels {

/// The kernels of the point-based method as the engine calls them: one table of functions for each
/// instruction set, each function working on one block of nodes. Kernels never allocate, throw,
/// print, or keep state. Instantiated for double and float in 2D and 3D. Half of a step is
/// gathering points and scattering forces, four values at a time: AVX-512 takes the kernels of
/// AVX2.
template <class T, int D>
struct PointBasedTable {
  PointForcesResult (*evaluate_forces)(const PointForces<T, D>&);
  PointMotionSums (*advance)(const PointMotion<T, D>&);
  void (*drift)(const PointDrift<T, D>&);
  std::array<double, D> (*momentum)(const PointMomentum<T, D>&);

  /// Kernels for processors that run `isa`.
  static const PointBasedTable& of(Isa isa);
};

/// Those compiled for `isa`.
template <Isa isa, class T, int D>
PointBasedTable<T, D> point_based_kernels();

}  // namespace pliant::kernels
