#include "kernels/total_lagrangian/kernels.hpp"

namespace pliant::kernels {

template TotalLagrangianTable<double, 2> total_lagrangian_kernels<Isa::PLIANT_ISA, double, 2>();
template TotalLagrangianTable<double, 3> total_lagrangian_kernels<Isa::PLIANT_ISA, double, 3>();

}  // namespace pliant::kernels
