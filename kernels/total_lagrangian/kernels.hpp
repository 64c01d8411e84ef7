#pragma once

#include "kernels/compiled_for.hpp"
#include "kernels/total_lagrangian/motion.hpp"
#include "kernels/total_lagrangian/table.hpp"

namespace pliant::kernels {

template <Isa isa, class T, int D>
TotalLagrangianTable<T, D> total_lagrangian_kernels() {
  using P = PackOf<isa, T>;
  return {advance_motion<P, D>};
}

}  // namespace pliant::kernels
