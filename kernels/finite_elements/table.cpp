#include "kernels/finite_elements/table.hpp"

#include "kernels/compiled_for.hpp"

namespace pliant::kernels {

template <class T, int D>
const FiniteElementsTable<T, D>& FiniteElementsTable<T, D>::of(Isa isa) {
  static const FiniteElementsTable sse2 = finite_elements_kernels<Isa::sse2, T, D>(),
                                   avx2 = finite_elements_kernels<Isa::avx2, T, D>();
  return isa == Isa::sse2 ? sse2 : avx2;
}

template struct FiniteElementsTable<double, 2>;
template struct FiniteElementsTable<double, 3>;
template struct FiniteElementsTable<float, 2>;
template struct FiniteElementsTable<float, 3>;

}  // namespace pliant::kernels
