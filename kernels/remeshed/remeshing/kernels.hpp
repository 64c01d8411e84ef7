#pragma once

#include "kernels/compiled_for.hpp"
#include "kernels/remeshed/remeshing/closest_point.hpp"
#include "kernels/remeshed/remeshing/filter.hpp"
#include "kernels/remeshed/remeshing/scatter.hpp"

namespace pliant::kernels {

template <Isa isa, class T, int D>
RemeshingKernels<T, D> remeshing_kernels() {
  using P = PackOf<isa, T>;
  return {scatter<P, D>, filter<P, D>, find_closest_points<P, D>};
}

}  // namespace pliant::kernels
