#include "kernels/instantiate.hpp"
#include "kernels/isa/tables.hpp"

namespace pliant::kernels {

template <int D>
const Table<double, D>& avx2_table() {
  static constexpr Table<double, D> table =
      make_table<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>, D>(Isa::avx2);
  return table;
}

template const Table<double, 2>& avx2_table<2>();
template const Table<double, 3>& avx2_table<3>();

}  // namespace pliant::kernels
