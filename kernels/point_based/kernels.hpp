#pragma once

#include "kernels/compiled_for.hpp"
#include "kernels/point_based/forces.hpp"
#include "kernels/point_based/motion.hpp"
#include "kernels/point_based/table.hpp"
#ifdef __AVX2__
#include "kernels/point_based/point_lanes_avx2.hpp"
#endif

namespace pliant::kernels {

template <Isa isa, class T, int D>
PointBasedTable<T, D> point_based_kernels() {
  using P = PackOf<isa, T>;
  return {evaluate_point_forces<P, D>, advance_points<P, D>, drift_points<P, D>,
          momentum_of_points<P, D>};
}

}  // namespace pliant::kernels
