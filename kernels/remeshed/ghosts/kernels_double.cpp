#include "kernels/remeshed/ghosts/kernels.hpp"

namespace pliant::kernels {

template GhostKernels<double, 2> ghost_kernels<Isa::PLIANT_ISA, double, 2>();
template GhostKernels<double, 3> ghost_kernels<Isa::PLIANT_ISA, double, 3>();

}  // namespace pliant::kernels
