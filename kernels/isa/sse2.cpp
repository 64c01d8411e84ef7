#include "kernels/instantiate.hpp"
#include "kernels/isa/tables.hpp"

namespace pliant::kernels {

template <int D>
const Table<double, D>& sse2_table() {
  static constexpr Table<double, D> table =
      make_table<xsimd::batch<double, xsimd::sse2>, D>(Isa::sse2);
  return table;
}

template const Table<double, 2>& sse2_table<2>();
template const Table<double, 3>& sse2_table<3>();

}  // namespace pliant::kernels
