#include "kernels/total_lagrangian/kernels.hpp"

namespace pliant::kernels {

template TotalLagrangianTable<float, 2> total_lagrangian_kernels<Isa::PLIANT_ISA, float, 2>();
template TotalLagrangianTable<float, 3> total_lagrangian_kernels<Isa::PLIANT_ISA, float, 3>();

}  // namespace pliant::kernels
