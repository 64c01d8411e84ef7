#include "kernels/remeshed/table.hpp"

#include "kernels/compiled_for.hpp"

namespace pliant::kernels {

namespace {

template <Isa isa, class T, int D>
RemeshedTable<T, D> compiled_for() {
  return {stage_kernels<isa, T, D>(), ghost_kernels<isa, T, D>(), remeshing_kernels<isa, T, D>()};
}

}  // namespace

template <class T, int D>
const RemeshedTable<T, D>& RemeshedTable<T, D>::of(Isa isa) {
  static const RemeshedTable sse2 = compiled_for<Isa::sse2, T, D>(),
                             avx2 = compiled_for<Isa::avx2, T, D>(),
                             widest = compiled_for<widest_of<T>, T, D>();
  return isa == Isa::sse2 ? sse2 : isa == Isa::avx2 ? avx2 : widest;
}

template struct RemeshedTable<double, 2>;
template struct RemeshedTable<double, 3>;
template struct RemeshedTable<float, 2>;
template struct RemeshedTable<float, 3>;

}  // namespace pliant::kernels
