#include "kernels/remeshed/ghosts/kernels.hpp"

namespace pliant::kernels {

template GhostKernels<float, 2> ghost_kernels<Isa::PLIANT_ISA, float, 2>();
template GhostKernels<float, 3> ghost_kernels<Isa::PLIANT_ISA, float, 3>();

}  // namespace pliant::kernels
