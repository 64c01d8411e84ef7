#include "kernels/instantiate.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {

using Arch = xsimd::sse2;
constexpr Table<float, 2> sse2_table_float = make_table<xsimd::batch<float, Arch>, 2>(Isa::sse2);

}  // namespace pliant::kernels::test
