#include "engine/remeshed/setup/initial_fields.hpp"

#include <algorithm>
#include <cmath>

#include "engine/blocks/box.hpp"
#include "engine/case/attached_walls.hpp"
#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/setup/initial_state.hpp"
#include "engine/remeshed/setup/particle_kinds.hpp"

namespace pliant::remeshed {

namespace {

/// Whether x is behind the walls, and not only in the part of them that holds ghosts.
bool is_beyond(const Box<3>& body, const Vector& x, int dimension, double h) {
  for (int a = 0; a < dimension; ++a) {
    if (x[a] < body.lower[a] - (ghost_band + 1) * h) return true;
    if (x[a] > body.upper[a] + (ghost_band + 1) * h) return true;
  }
  return false;
}

}  // namespace

template <class T, int D>
bool set_initial_fields(const Case& settings, Body<T, D>& body, T* valid) {
  const BodyCase& source = *body.source;
  const double h = body.lattice.spacing;
  const double limit = LevelSet<T, D>::far * h;
  const Shape surface = initial_surface(settings, source);
  FieldStore<T, D>& state = body.stage[1];
  const T volume = static_cast<T>(std::pow(h, D));
  const bool deforms = kernels::carries_deformation(body.material.model);
  T volume_ratio = 1;
  for (int a = 0; a < D; ++a) volume_ratio *= static_cast<T>(source.stretch[a]);
  bool has_surface = false;
  DistanceWalk distance(surface, D, limit);
  const Box<3> box = bounding_box(source.geometry);
  for (const Block<D>& block : body.spare.layout.blocks()) {
    body.spare.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& at) {
      const Vector x = padded<D>(body.lattice.node(body.lattice.wrapped(at)));
      const double phi = is_beyond(box, x, D, h) ? limit : distance(x);
      state.get(Field::level_set)[p] = static_cast<T>(std::clamp(phi, -limit, limit));
      has_surface = has_surface || phi > -limit;
      valid[p] = phi < ghost_band * h ? T(1) : T(0);
      const Vector u = initial_velocity(source, x);
      for (int a = 0; a < D; ++a) state.get(Field::velocity, a)[p] = static_cast<T>(u[a]);
      state.get(Field::volume)[p] = volume;
      state.get(Field::mass)[p] = body.material.density * volume / volume_ratio;
      for (int c = 0; c < state.material_components(); ++c) {
        state.get(Field::material, c)[p] =
            deforms && c % (D + 1) == 0 ? static_cast<T>(source.stretch[c / (D + 1)]) : T(0);
      }
      for (Buffer<T>& pressure : state[Field::memory_pressure]) pressure[p] = 0;
      if (source.stress && valid[p] > 0) {
        const InitialState<D> stressed = state_under_stress<D>(source, x);
        state.get(Field::mass)[p] = static_cast<T>(body.mass_scaling * stressed.density) * volume;
        for (int c = 0; c < state.material_components(); ++c) {
          state.get(Field::material, c)[p] = static_cast<T>(stressed.material[c]);
        }
      }
    });
  }
  return has_surface;
}

template bool set_initial_fields<double, 2>(const Case&, Body<double, 2>&, double*);
template bool set_initial_fields<double, 3>(const Case&, Body<double, 3>&, double*);
template bool set_initial_fields<float, 2>(const Case&, Body<float, 2>&, float*);
template bool set_initial_fields<float, 3>(const Case&, Body<float, 3>&, float*);

}  // namespace pliant::remeshed
