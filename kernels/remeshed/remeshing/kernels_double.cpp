#include "kernels/remeshed/remeshing/kernels.hpp"

namespace pliant::kernels {

template RemeshingKernels<double, 2> remeshing_kernels<Isa::PLIANT_ISA, double, 2>();
template RemeshingKernels<double, 3> remeshing_kernels<Isa::PLIANT_ISA, double, 3>();

}  // namespace pliant::kernels
