#include "engine/remeshed/remeshing/free_motion_correction.hpp"

#include <algorithm>

#include "engine/boundaries/rigid_motion.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/remeshing/rigid_motion.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/state/resources.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;

template <int D>
void add(ForceOnBlock<D>& sum, const ForceOnBlock<D>& other) {
  sum.mass += other.mass;
  for (int a = 0; a < D; ++a) sum.first_moment[a] += other.first_moment[a];
  sum.force.add(other.force, 1);
}

/// Adds the impulse of a force on the particles, whose mass sum may differ from that of the body.
template <int D>
void add_impulse(MotionBudget<D>& budget, const ForceOnBlock<D>& on_body, double duration) {
  if (on_body.mass == 0) return;
  const double share = duration * budget.mass / on_body.mass;
  Vector centre = padded<D>(on_body.first_moment);
  for (double& component : centre) component /= on_body.mass;
  const Vector about_centre = on_body.force.moment_about(centre);
  for (int a = 0; a < D; ++a) budget.momentum[a] += share * on_body.force.force[a];
  for (int a = 0; a < 3; ++a) budget.spin[a] += share * about_centre[a];
}

template <class T, int D>
bool is_held(const Body<T, D>& body) {
  const auto is_load = [](std::int8_t load) { return load != no_load; };
  const auto is_wall = [](std::int8_t wall) { return wall >= 0; };
  return std::ranges::any_of(body.population.ghosts, [&](const BlockGhosts<T, D>& ghosts) {
    return std::ranges::any_of(ghosts.pressure, is_load) ||
           std::ranges::any_of(ghosts.wall, is_wall);
  });
}

template <class T, int D>
bool touches_another(const Body<T, D>& body) {
  return std::ranges::any_of(body.population.ghosts, [](const BlockGhosts<T, D>& ghosts) {
    return !ghosts.contact_points.ghost.empty();
  });
}

}  // namespace

template <class T, int D>
void FreeMotionCorrection<T, D>::add_step(const std::vector<std::array<ForceOnBlock<D>, 4>>& forces,
                                          double time_step) {
  for (int stage = 0; stage < 4; ++stage) {
    on_body_.assign(state_.bodies.size(), {});
    for (std::size_t b = 0; b < forces.size(); ++b) {
      add(on_body_[state_.blocks[b].body], forces[b][stage]);
    }
    for (std::size_t b = 0; b < on_body_.size(); ++b) {
      add_impulse(state_.motion_budgets[b], on_body_[b], stage_weight[stage] * time_step);
    }
  }
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    if (touches_another(state_.bodies[b])) state_.motion_budgets[b].is_known = false;
  }
}

template <class T, int D>
void FreeMotionCorrection<T, D>::add_phases(std::vector<Phase>& phases) {
  of_block_.resize(state_.blocks.size());
  using namespace resource;
  using enum Group;
  PhaseRows rows(phases);
  rows.each("motion", near(slots(velocity) + slots(material) + slots(constants) + whole(kinds)),
            own(whole(motion)), [this](int block) { integrate(block); });
  rows.reduce("motion", all(whole(motion) + whole(motion_budgets)), all(whole(motion_budgets)),
              [this] { balance(); });
  rows.each("motion", all(whole(motion_budgets)) + own(slots(velocity) + whole(kinds)),
            own(slots(velocity)), [this](int block) { correct(block); });
}

template <class T, int D>
void FreeMotionCorrection<T, D>::integrate(int block) {
  const auto owner = state_.owner(block);
  const Body<T, D>& body = owner.body;
  MotionIntegrals& sum = of_block_[block] = {};
  if (!is_followed(body) || (is_held(body) && !weighs_held_bodies_)) return;
  const CoveredCells<T, D> cells({body, body.population, body.stage[0]}, state_.boundaries);
  cells.for_each(body.population.layout.blocks()[owner.block],
                 [&](std::int64_t p, const Cell<D>& cell, const Moments<D>& moments) {
                   sum.add<D>(body.lattice.spacing, body.lattice.node(cell),
                              NodeMotion<D>(body.stage[0], cells, p, cell), moments);
                 });
}

template <class T, int D>
void FreeMotionCorrection<T, D>::balance() {
  sums_.assign(state_.bodies.size(), {});
  for (std::size_t b = 0; b < of_block_.size(); ++b)
    add(sums_[state_.blocks[b].body], of_block_[b]);
  of_body_.assign(sums_.size(), {});
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const MotionIntegrals& now = sums_[b];
    MotionBudget<D>& budget = state_.motion_budgets[b];
    if (!is_followed(state_.bodies[b])) continue;
    if (is_held(state_.bodies[b])) {
      budget.is_known = false;
    } else if (budget.is_known) {
      for (double& component : budget.momentum) component *= now.mass / budget.mass;
      of_body_[b] = correction(now, budget);
    } else {
      std::copy_n(now.momentum.begin(), D, budget.momentum.begin());
      budget.spin = spin_of(now);
      budget.is_known = true;
    }
    budget.mass = now.mass;
  }
}

// The correction (RP.90).
template <class T, int D>
auto FreeMotionCorrection<T, D>::correction(const MotionIntegrals& now,
                                            const MotionBudget<D>& budget) const -> Correction {
  Correction found;
  found.acts = true;
  found.centre = mass_centre(now);
  for (int a = 0; a < D && keeps_velocity_; ++a) {
    found.velocity[a] = (budget.momentum[a] - now.momentum[a]) / now.mass;
  }
  Vector missing = spin_of(now);
  for (int a = 0; a < 3; ++a) missing[a] = budget.spin[a] - missing[a];
  found.angular_velocity = angular_velocity<D>(now, missing);
  return found;
}

template <class T, int D>
void FreeMotionCorrection<T, D>::correct(int block) {
  const Correction& by = of_body_[state_.blocks[block].body];
  if (!by.acts) return;
  const auto owner = state_.owner(block);
  Body<T, D>& body = owner.body;
  const Layout<D>& layout = body.population.layout;
  std::array<T*, D> u;
  for (int a = 0; a < D; ++a) u[a] = body.stage[0].get(Field::velocity, a);
  layout.for_each_slot(layout.blocks()[owner.block], [&](std::int64_t p, const Cell<D>& cell) {
    if (body.population.kind[p] == Kind::vacant) return;
    Vector r = padded<D>(body.lattice.node(cell));
    for (int a = 0; a < D; ++a) r[a] -= by.centre[a];
    const Vector turned = cross(by.angular_velocity, r);
    for (int a = 0; a < D; ++a) u[a][p] += static_cast<T>(by.velocity[a] + turned[a]);
  });
}

template class FreeMotionCorrection<double, 2>;
template class FreeMotionCorrection<double, 3>;
template class FreeMotionCorrection<float, 2>;
template class FreeMotionCorrection<float, 3>;

}  // namespace pliant::remeshed
