#pragma once

#include "kernels/isa.hpp"
#include "kernels/point_based/arguments.hpp"

namespace pliant::kernels {

/// The kernels of the point-based method for the engine: a table of functions for each instruction
/// set, each for one block of nodes. Kernels never allocate, throw, print, or keep state.
/// Instantiated for double and float in 2D and 3D. AVX-512 uses the kernels of AVX2: half of a step
/// gathers points and scatters forces, four values at a time.
template <class T, int D>
struct PointBasedTable {
  PointForcesResult (*evaluate_forces)(const PointForces<T, D>&);
  PointMotionSums (*advance)(const PointMotion<T, D>&);
  void (*drift)(const PointDrift<T, D>&);
  std::array<double, D> (*momentum)(const PointMomentum<T, D>&);

  static const PointBasedTable& of(Isa isa);
};

template <Isa isa, class T, int D>
PointBasedTable<T, D> point_based_kernels();

}  // namespace pliant::kernels
