#include "kernels/finite_elements/kernels.hpp"

namespace pliant::kernels {

template FiniteElementsTable<double, 2> finite_elements_kernels<Isa::PLIANT_ISA, double, 2>();
template FiniteElementsTable<double, 3> finite_elements_kernels<Isa::PLIANT_ISA, double, 3>();

}  // namespace pliant::kernels
