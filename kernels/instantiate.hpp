#pragma once

#include "kernels/closest_point.hpp"
#include "kernels/filter.hpp"
#include "kernels/free_surface_ghosts.hpp"
#include "kernels/ghost_sums.hpp"
#include "kernels/motion.hpp"
#include "kernels/scatter.hpp"
#include "kernels/stage.hpp"
#include "kernels/state_stress.hpp"
#include "kernels/stress_points.hpp"
#include "kernels/surface.hpp"
#include "kernels/surface_fits.hpp"

namespace pliant::kernels {

/// The kernels for packs `P`.
template <class P, int D>
constexpr Table<Scalar<P>, D> make_table(Isa isa) {
  return {isa,
          lanes<P>,
          advance_stage<P, D>,
          evaluate_stress<P, D>,
          write_surface_records<P, D>,
          sum_ghosts<P, D>,
          sum_velocities<P, D>,
          fill_free_surfaces<P, D>,
          scatter<P, D>,
          filter<P, D>,
          find_closest_points<P, D>,
          fit_surface<P, D>,
          evaluate_stress_points<P, D>,
          advance_motion<P, D>};
}

}  // namespace pliant::kernels
