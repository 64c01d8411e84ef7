#include "engine/remeshed/body_forces.hpp"

#include "engine/remeshed/runge_kutta.hpp"

namespace pliant::remeshed {

namespace {

// What a rate of each stage counts for in the state that the stage leaves behind, (RP.21).
constexpr std::array<double, 4> share_of_rate = {0.5, 0.5, 1, 1. / 6};

}  // namespace

template <class T, int D>
BodyForces<T, D>::BodyForces(State<T, D>& state, const Case& settings)
    : state_(state), gravity_(settings), damping_(settings.discretisation.damping) {}

template <class T, int D>
void BodyForces<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  gravity_.reserve(state_.blocks.size());
  of_block_.assign(state_.blocks.size(), {});
  impulse_.assign(state_.blocks.size(), {});
}

template <class T, int D>
BodyForce<D> BodyForces<T, D>::of(int block, int stage) const {
  const double t = state_.clock.time + stage_time[stage] * time_step_;
  return {typename Gravity<D>::Now(gravity_, block, t), damping_, gravity_.acts() || damping_ != 0};
}

template <class T, int D>
void BodyForces<T, D>::advance(int block, int stage) {
  if (!gravity_.acts() && damping_ == 0) return;
  const auto owner = state_.owner(block);
  Body<T, D>& body = owner.body;
  const FieldStore<T, D>& current = body.stage[buffer_of(stage)];
  FieldStore<T, D>& next = body.stage[buffer_after(stage)];
  const T* mass = body.stage[0].get(Field::mass);
  const double t = state_.clock.time + stage_time[stage] * time_step_;
  const double share = share_of_rate[stage] * time_step_;
  double power = 0, lost = 0;
  Point<D> force = {};
  const auto add_to = [&](std::int64_t p, const Point<D>& g) {
    double along = 0, square = 0;
    for (int a = 0; a < D; ++a) {
      const double u = current.get(Field::velocity, a)[p];
      along += g[a] * u;
      square += u * u;
      const double rate = g[a] - damping_ * u;
      next.get(Field::velocity, a)[p] += static_cast<T>(share * rate);
      force[a] += mass[p] * rate;
    }
    power += mass[p] * along;
    lost += mass[p] * damping_ * square;
  };
  const Layout<D>& layout = body.population.layout;
  const auto for_each_particle = [&](auto&& f) {
    layout.for_each_slot(layout.blocks()[owner.block], [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] == Kind::interior) f(p, cell);
    });
  };
  if (gravity_.acts()) {
    const typename Gravity<D>::Now gravity(gravity_, block, t);
    for_each_particle([&](std::int64_t p, const Cell<D>& cell) {
      Point<D> x = body.lattice.node(cell);
      for (int a = 0; a < D; ++a) x[a] += current.get(Field::drift, a)[p];
      add_to(p, gravity(x));
    });
  } else {
    for_each_particle([&](std::int64_t p, const Cell<D>&) { add_to(p, {}); });
  }
  const double duration = stage_weight[stage] * time_step_;
  for (int a = 0; a < D; ++a) impulse_[block][a] += duration * force[a];
  of_block_[block].body_force_work += duration * power;
  of_block_[block].damping += duration * lost;
}

template <class T, int D>
void BodyForces<T, D>::fold() {
  for (const EnergyBudget& budget : of_block_) add(state_.energy, budget);
}

template class BodyForces<double, 2>;
template class BodyForces<double, 3>;
template class BodyForces<float, 2>;
template class BodyForces<float, 3>;

}  // namespace pliant::remeshed
