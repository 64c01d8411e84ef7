#pragma once

#include "kernels/remeshed/ghosts/arguments.hpp"
#include "kernels/remeshed/remeshing/arguments.hpp"
#include "kernels/remeshed/stage/arguments.hpp"

namespace pliant::kernels {

/// The kernels of remeshed particles for the engine: a table of functions for each instruction set,
/// each for one block of slots. Kernels never allocate, throw, print, or keep state. Instantiated
/// for double and float in 2D and 3D.
template <class T, int D>
struct RemeshedTable : StageKernels<T, D>, GhostKernels<T, D>, RemeshingKernels<T, D> {
  static const RemeshedTable& of(Isa isa);
};

}  // namespace pliant::kernels
