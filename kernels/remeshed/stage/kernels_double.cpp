#include "kernels/remeshed/stage/kernels.hpp"

namespace pliant::kernels {

template StageKernels<double, 2> stage_kernels<Isa::PLIANT_ISA, double, 2>();
template StageKernels<double, 3> stage_kernels<Isa::PLIANT_ISA, double, 3>();

}  // namespace pliant::kernels
