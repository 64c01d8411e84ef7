#include "kernels/isa/avx512_fma.hpp"

#include "kernels/instantiate.hpp"
#include "kernels/isa/tables.hpp"

namespace pliant::kernels {

constexpr Table<double, 2> avx512_table =
    make_table<xsimd::batch<double, xsimd::avx512bw>, 2>(Isa::avx512);

}  // namespace pliant::kernels
