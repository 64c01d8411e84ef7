#include "kernels/finite_elements/kernels.hpp"

namespace pliant::kernels {

template FiniteElementsTable<float, 2> finite_elements_kernels<Isa::PLIANT_ISA, float, 2>();
template FiniteElementsTable<float, 3> finite_elements_kernels<Isa::PLIANT_ISA, float, 3>();

}  // namespace pliant::kernels
