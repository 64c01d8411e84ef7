#include "kernels/remeshed/stage/kernels.hpp"

namespace pliant::kernels {

template StageKernels<float, 2> stage_kernels<Isa::PLIANT_ISA, float, 2>();
template StageKernels<float, 3> stage_kernels<Isa::PLIANT_ISA, float, 3>();

}  // namespace pliant::kernels
