#include "kernels/point_based/kernels.hpp"

namespace pliant::kernels {

template PointBasedTable<float, 2> point_based_kernels<Isa::PLIANT_ISA, float, 2>();
template PointBasedTable<float, 3> point_based_kernels<Isa::PLIANT_ISA, float, 3>();

}  // namespace pliant::kernels
