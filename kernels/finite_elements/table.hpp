#pragma once

#include "kernels/finite_elements/arguments.hpp"
#include "kernels/isa.hpp"

namespace pliant::kernels {

/// The table of the kernels of finite elements, like PointBasedTable; nodes move by the kernels of
/// that table.
template <class T, int D>
struct FiniteElementsTable {
  void (*collect_dilatation)(const ElementBlock<T, D>&);
  void (*evaluate_nodal_pressures)(const NodalPressures<T>&);
  PointForcesResult (*evaluate_forces)(const ElementBlock<T, D>&);

  static const FiniteElementsTable& of(Isa isa);
};

template <Isa isa, class T, int D>
FiniteElementsTable<T, D> finite_elements_kernels();

}  // namespace pliant::kernels
