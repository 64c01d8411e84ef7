#include "kernels/instantiate.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {

using Arch = xsimd::fma3<xsimd::avx2>;
constexpr Table<float, 2> avx2_table_float = make_table<xsimd::batch<float, Arch>, 2>(Isa::avx2);

}  // namespace pliant::kernels::test
