#include "kernels/total_lagrangian/table.hpp"

#include "kernels/compiled_for.hpp"

namespace pliant::kernels {

template <class T, int D>
const TotalLagrangianTable<T, D>& TotalLagrangianTable<T, D>::of(Isa isa) {
  static const TotalLagrangianTable sse2 = total_lagrangian_kernels<Isa::sse2, T, D>(),
                                    avx2 = total_lagrangian_kernels<Isa::avx2, T, D>(),
                                    widest = total_lagrangian_kernels<widest_of<T>, T, D>();
  return isa == Isa::sse2 ? sse2 : isa == Isa::avx2 ? avx2 : widest;
}

template struct TotalLagrangianTable<double, 2>;
template struct TotalLagrangianTable<double, 3>;
template struct TotalLagrangianTable<float, 2>;
template struct TotalLagrangianTable<float, 3>;

}  // namespace pliant::kernels
