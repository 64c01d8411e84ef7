#pragma once

#include "kernels/compiled_for.hpp"
#include "kernels/remeshed/ghosts/free_surface_ghosts.hpp"
#include "kernels/remeshed/ghosts/ghost_sums.hpp"
#include "kernels/remeshed/ghosts/surface_fits.hpp"
#include "kernels/remeshed/ghosts/surface_records.hpp"

namespace pliant::kernels {

template <Isa isa, class T, int D>
GhostKernels<T, D> ghost_kernels() {
  using P = PackOf<isa, T>;
  return {write_surface_records<P, D>, sum_ghosts<P, D>, sum_velocities<P, D>,
          fill_free_surfaces<P, D>, fit_surface<P, D>};
}

}  // namespace pliant::kernels
