#pragma once

#include "kernels/compiled_for.hpp"
#include "kernels/remeshed/stage/lattice_gradient.hpp"
#include "kernels/remeshed/stage/stage.hpp"
#include "kernels/remeshed/stage/state_stress.hpp"

namespace pliant::kernels {

template <Isa isa, class T, int D>
StageKernels<T, D> stage_kernels() {
  using P = PackOf<isa, T>;
  return {advance_stage<P, D>, evaluate_stress<P, D>, lattice_gradient<P, D>};
}

}  // namespace pliant::kernels
