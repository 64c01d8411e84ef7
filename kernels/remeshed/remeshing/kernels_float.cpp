#include "kernels/remeshed/remeshing/kernels.hpp"

namespace pliant::kernels {

template RemeshingKernels<float, 2> remeshing_kernels<Isa::PLIANT_ISA, float, 2>();
template RemeshingKernels<float, 3> remeshing_kernels<Isa::PLIANT_ISA, float, 3>();

}  // namespace pliant::kernels
