#include "kernels/instantiate.hpp"
#include "kernels/isa/tables.hpp"

namespace pliant::kernels {

constexpr Table<double, 2> avx2_table =
    make_table<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>, 2>(Isa::avx2);

}  // namespace pliant::kernels
