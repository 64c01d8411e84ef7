#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Sums over the interior particles of a block.
template <int D>
struct ParticleMomentum {
  double mass = 0;         ///< sum m [kg]
  Point<D> momentum = {};  ///< sum m u [N s]
};

template <int D>
void add(ParticleMomentum<D>& sum, const ParticleMomentum<D>& other) {
  sum.mass += other.mass;
  for (int a = 0; a < D; ++a) sum.momentum[a] += other.momentum[a];
}

/// With the velocities of `state`, one of the copies of the body's state.
template <class T, int D>
ParticleMomentum<D> particle_momentum(const Body<T, D>& body, int block,
                                      const FieldStore<T, D>& state) {
  const T* mass = body.stage[0].get(Field::mass);
  const Kind* kind = body.population.kind.get();
  std::array<const T*, D> u;
  for (int a = 0; a < D; ++a) u[a] = state.get(Field::velocity, a);
  ParticleMomentum<D> sum;
  const Layout<D>& layout = body.population.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>&) {
    if (kind[p] != Kind::interior) return;
    sum.mass += mass[p];
    for (int a = 0; a < D; ++a) sum.momentum[a] += double{mass[p]} * u[a][p];
  });
  return sum;
}

}  // namespace pliant::remeshed
