#include "engine/remeshed/loads/body_forces.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/remeshed/loads/shear_patches.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/runge_kutta.hpp"

namespace pliant::remeshed {

namespace {

// Weight of a rate in the state that its stage writes, (RP.21).
constexpr std::array<double, 4> share_of_rate = {0.5, 0.5, 1, 1. / 6};

/// Calls f(slot, cell) for each particle of a block.
template <class T, int D, class F>
void for_each_particle(const Body<T, D>& body, int block, F&& f) {
  const Layout<D>& layout = body.population.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (body.population.kind[p] == Kind::interior) f(p, cell);
  });
}

template <int D>
void add_particle(ForceOnBlock<D>& sum, double mass, const Point<D>& x, const Point<D>& force) {
  sum.mass += mass;
  for (int a = 0; a < D; ++a) sum.first_moment[a] += mass * x[a];
  sum.force.add(x, force);
}

}  // namespace

template <class T, int D>
BodyForces<T, D>::BodyForces(State<T, D>& state, const Case& settings)
    : state_(state),
      gravity_(settings),
      mass_scaling_(parameters_of(settings).mass_scaling),
      is_adaptive_(damps_adaptively(settings)) {}

template <class T, int D>
void BodyForces<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  of_block_.assign(state_.blocks.size(), {});
  impulse_.assign(state_.blocks.size(), {});
  forces_.assign(state_.blocks.size(), {});
  motion_.assign(state_.blocks.size(), {});
}

template <class T, int D>
BodyForce<D> BodyForces<T, D>::at(int stage) const {
  const double t = state_.clock.time + stage_time[stage] * time_step_;
  const double damping = state_.clock.damping;
  return {typename Gravity<D>::Now(gravity_, t), mass_scaling_, damping,
          gravity_.acts() || damping != 0};
}

template <class T, int D>
void BodyForces<T, D>::advance(int block, int stage) {
  if (is_adaptive_ && stage < 2) follow(block, stage);
  const BodyForce<D> force_of = at(stage);
  if (force_of.acts) apply_field(block, stage, force_of);
  const auto owner = state_.owner(block);
  if (!owner.body.shear.empty()) apply_shear(block, stage);
}

template <class T, int D>
void BodyForces<T, D>::apply_field(int block, int stage, const BodyForce<D>& force_of) {
  const auto owner = state_.owner(block);
  Body<T, D>& body = owner.body;
  const FieldStore<T, D>& current = body.stage[buffer_of(stage)];
  const FieldStore<T, D>& places = body.stage[drift_buffer_of(stage)];
  FieldStore<T, D>& next = body.stage[buffer_after(stage)];
  const T* mass = body.stage[0].get(Field::mass);
  const double share = share_of_rate[stage] * time_step_;
  double power = 0, lost = 0;
  ForceOnBlock<D> sum;
  for_each_particle(body, owner.block, [&](std::int64_t p, const Cell<D>& cell) {
    Point<D> x = body.lattice.node(cell), force;
    for (int a = 0; a < D; ++a) x[a] += places.get(Field::drift, a)[p];
    const Point<D> g = gravity_.acts() ? force_of.of_gravity(x) : Point<D>{};
    double along = 0, square = 0;
    for (int a = 0; a < D; ++a) {
      const double u = current.get(Field::velocity, a)[p];
      along += g[a] * u;
      square += u * u;
      const double rate = g[a] - force_of.damping * u;
      next.get(Field::velocity, a)[p] += static_cast<T>(share * rate);
      force[a] = mass[p] * rate;
    }
    add_particle<D>(sum, mass[p], x, force);
    power += mass[p] * along;
    lost += mass[p] * force_of.damping * square;
  });
  const double duration = stage_weight[stage] * time_step_;
  for (int a = 0; a < D; ++a) impulse_[block][a] += duration * sum.force.force[a];
  forces_[block][stage] = sum;
  of_block_[block].body_force_work += duration * power;
  of_block_[block].damping += duration * lost;
}

template <class T, int D>
void BodyForces<T, D>::apply_shear(int block, int stage) {
  const auto owner = state_.owner(block);
  Body<T, D>& body = owner.body;
  FieldStore<T, D>& next = body.stage[buffer_after(stage)];
  const T* mass = body.stage[0].get(Field::mass);
  const double share_of_step = share_of_rate[stage] * time_step_;
  for (const auto& index : body.shear[owner.block].own) {
    const BlockShear<D>& from = body.shear[index.block];
    const ShearShare<D>& share = from.shares[index.share];
    const ShearPatch<D>& patch = from.patches[share.patch];
    const Point<D> force = shear_force(patch, share);
    for (int a = 0; a < D; ++a) {
      next.get(Field::velocity, a)[share.slot] +=
          static_cast<T>(share_of_step * force[a] / mass[share.slot]);
    }
  }
}

template <class T, int D>
void BodyForces<T, D>::follow(int block, int stage) {
  const auto owner = state_.owner(block);
  const Body<T, D>& body = owner.body;
  const FieldStore<T, D>& start = body.stage[0];
  const FieldStore<T, D>& next = body.stage[buffer_after(stage)];
  const T* mass = start.get(Field::mass);
  double inertia = 0, gain = 0;
  for_each_particle(body, owner.block, [&](std::int64_t p, const Cell<D>&) {
    for (int a = 0; a < D; ++a) {
      const double u = start.get(Field::velocity, a)[p];
      inertia += mass[p] * u * u;
      gain += mass[p] * u * (next.get(Field::velocity, a)[p] - u);
    }
  });
  motion_[block].inertia = inertia;
  motion_[block].gain[stage] = gain;
}

// (RP.88): each of the first two stages adds dt/2 times its acceleration; that of the second is at
// places dt/2 later.
template <class T, int D>
void BodyForces<T, D>::adapt_damping() {
  Motion sum;
  for (const Motion& motion : motion_) {
    sum.inertia += motion.inertia;
    sum.gain[0] += motion.gain[0];
    sum.gain[1] += motion.gain[1];
  }
  const double change = 4 * (sum.gain[0] - sum.gain[1]);
  const double angle2 = sum.inertia > 0 ? std::max(change / sum.inertia, 0.) : 0;
  state_.clock.damping = std::min(2 * std::sqrt(angle2), 1.) / time_step_;
}

template <class T, int D>
void BodyForces<T, D>::fold() {
  for (const EnergyBudget& budget : of_block_) add(state_.energy, budget);
  if (is_adaptive_ && time_step_ > 0) adapt_damping();
}

template class BodyForces<double, 2>;
template class BodyForces<double, 3>;
template class BodyForces<float, 2>;
template class BodyForces<float, 3>;

}  // namespace pliant::remeshed
