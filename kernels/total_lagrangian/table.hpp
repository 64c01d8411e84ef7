#pragma once

#include "kernels/isa.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

namespace pliant::kernels {

/// The kernels of the total Lagrangian method for the engine: a table of functions for each
/// instruction set, each for one block of slots. Kernels never allocate, throw, print, or keep
/// state. Instantiated for double and float in 2D and 3D.
template <class T, int D>
struct TotalLagrangianTable {
  MotionResult (*advance_motion)(const Motion<T, D>&);

  /// Kernels compiled for `isa`.
  static const TotalLagrangianTable& of(Isa isa);
};

template <Isa isa, class T, int D>
TotalLagrangianTable<T, D> total_lagrangian_kernels();

}  // namespace pliant::kernels
