#include "kernels/isa/avx512_fma.hpp"

#include "kernels/instantiate.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {

constexpr Table<double, 3> avx512_table_3d =
    make_table<xsimd::batch<double, xsimd::avx512bw>, 3>(Isa::avx512);

}  // namespace pliant::kernels::test
