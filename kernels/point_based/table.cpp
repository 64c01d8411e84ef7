#include "kernels/point_based/table.hpp"

#include "kernels/compiled_for.hpp"

namespace pliant::kernels {

template <class T, int D>
const PointBasedTable<T, D>& PointBasedTable<T, D>::of(Isa isa) {
  static const PointBasedTable sse2 = point_based_kernels<Isa::sse2, T, D>(),
                               avx2 = point_based_kernels<Isa::avx2, T, D>();
  return isa == Isa::sse2 ? sse2 : avx2;
}

template struct PointBasedTable<double, 2>;
template struct PointBasedTable<double, 3>;
template struct PointBasedTable<float, 2>;
template struct PointBasedTable<float, 3>;

}  // namespace pliant::kernels
