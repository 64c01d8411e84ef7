#include "kernels/instantiate.hpp"
#include "kernels/isa/tables.hpp"

namespace pliant::kernels {

constexpr Table<double, 2> sse2_table = make_table<xsimd::batch<double, xsimd::sse2>, 2>(Isa::sse2);

}  // namespace pliant::kernels
