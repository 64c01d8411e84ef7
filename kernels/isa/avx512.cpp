#include "kernels/isa/avx512_fma.hpp"

#include "kernels/instantiate.hpp"
#include "kernels/isa/tables.hpp"

namespace pliant::kernels {

template <int D>
const Table<double, D>& avx512_table() {
  static constexpr Table<double, D> table =
      make_table<xsimd::batch<double, xsimd::avx512bw>, D>(Isa::avx512);
  return table;
}

template const Table<double, 2>& avx512_table<2>();
template const Table<double, 3>& avx512_table<3>();

}  // namespace pliant::kernels
