#pragma once

#include "kernels/compiled_for.hpp"
#include "kernels/finite_elements/nodal_pressure.hpp"
#include "kernels/finite_elements/table.hpp"
#ifdef __AVX2__
#include "kernels/point_based/point_lanes_avx2.hpp"
#endif

namespace pliant::kernels {

template <Isa isa, class T, int D>
FiniteElementsTable<T, D> finite_elements_kernels() {
  using P = PackOf<isa, T>;
  return {collect_dilatation<P, D>, evaluate_nodal_pressures<P>, evaluate_element_forces<P, D>};
}

}  // namespace pliant::kernels
