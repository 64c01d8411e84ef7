#include "kernels/point_based/kernels.hpp"

namespace pliant::kernels {

template PointBasedTable<double, 2> point_based_kernels<Isa::PLIANT_ISA, double, 2>();
template PointBasedTable<double, 3> point_based_kernels<Isa::PLIANT_ISA, double, 3>();

}  // namespace pliant::kernels
