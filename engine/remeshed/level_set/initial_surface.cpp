#include "engine/remeshed/level_set/initial_surface.hpp"

#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/remeshed/level_set/level_set.hpp"

namespace pliant::remeshed {

namespace {

constexpr double recalled_share = 0.03;  // (RP.92)

}  // namespace

template <class T, int D>
void recall_initial_surface(const Lattice<D>& lattice, const Layout<D>& layout, int block,
                            const Shape& initial_surface, const T* valid,
                            FieldStore<T, D>& fields) {
  T* phi = fields.get(Field::level_set);
  const double h = lattice.spacing;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (valid[p] == 0 || std::abs(phi[p]) > LevelSet<T, D>::near_band * h) return;
    Point<D> start = lattice.node(cell);
    for (int a = 0; a < D; ++a) start[a] -= fields.get(Field::displacement, a)[p];
    const double recalled = signed_distance(initial_surface, padded<D>(start), D);
    phi[p] += static_cast<T>(recalled_share * (recalled - phi[p]));
  });
}

template void recall_initial_surface<double, 2>(const Lattice<2>&, const Layout<2>&, int,
                                                const Shape&, const double*,
                                                FieldStore<double, 2>&);
template void recall_initial_surface<double, 3>(const Lattice<3>&, const Layout<3>&, int,
                                                const Shape&, const double*,
                                                FieldStore<double, 3>&);
template void recall_initial_surface<float, 2>(const Lattice<2>&, const Layout<2>&, int,
                                               const Shape&, const float*, FieldStore<float, 2>&);
template void recall_initial_surface<float, 3>(const Lattice<3>&, const Layout<3>&, int,
                                               const Shape&, const float*, FieldStore<float, 3>&);

}  // namespace pliant::remeshed
