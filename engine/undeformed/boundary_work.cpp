#include "engine/undeformed/boundary_work.hpp"

#include <algorithm>

namespace pliant::undeformed {

template <class T, int D>
void BoundaryWork<T, D>::add_blocks(const Body<T, D>& body) {
  for (const auto& held : body.held) {
    BlockWork& work = work_.emplace_back();
    work.impulse.resize(state_.boundaries.walls.size());
    work.before.resize(held.size());
  }
}

template <class T, int D>
void BoundaryWork<T, D>::prepare(double time, double kick, double moved) {
  kick_ = kick;
  moved_ = moved;
  wall_motion_.clear();
  for (const Wall<D>& wall : state_.boundaries.walls) wall_motion_.push_back(wall.motion(time));
  state_.power = {};
  std::fill(state_.wall_force.begin(), state_.wall_force.end(), Wrench<D>{});
  for (BlockWork& work : work_) {
    work.energy = work.power = {};
    work.undamped = 0;
    std::fill(work.impulse.begin(), work.impulse.end(), Wrench<D>{});
  }
}

template <class T, int D>
void BoundaryWork<T, D>::begin_motion(int block, const Body<T, D>& body, int local,
                                      const EnergyBudget& power) {
  add(work_[block].energy, power, kick_ / 2);
  const auto& held = body.held[local];
  for (std::size_t i = 0; i < held.size(); ++i) {
    for (int a = 0; a < D; ++a) work_[block].before[i][a] = body.velocity[a][held[i].slot];
  }
}

template <class T, int D>
void BoundaryWork<T, D>::hold(int block, Body<T, D>& body, int local,
                              std::array<Buffer<T>, D>& displacement) {
  BlockWork& work = work_[block];
  const double inertia = state_.clock.mass_scaling * (1 + state_.clock.damping * kick_ / 2);
  const auto& particles = body.held[local];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const ConstrainedParticle<D>& held = particles[i];
    const Point<D> wall = wall_motion_[held.wall].of(held.start);
    Point<D> excess;
    double along = 0, slips = 0;
    for (int a = 0; a < D; ++a) {
      excess[a] = body.velocity[a][held.slot] - wall[a];
      along += excess[a] * held.normal[a];
      slips += held.normal[a] * held.normal[a];
    }
    Point<D> place = held.start, given;
    for (int a = 0; a < D; ++a) {
      const double undone = slips > 0 ? along * held.normal[a] : excess[a];
      body.velocity[a][held.slot] -= undone;
      displacement[a][held.slot] -= moved_ * undone;
      const double impulse = -inertia * body.mass[held.slot] * undone;
      place[a] += displacement[a][held.slot];
      given[a] = impulse;
      const double speed = body.velocity[a][held.slot], twice_mean = work.before[i][a] + speed;
      work.undamped += body.mass[held.slot] * undone * (2 * twice_mean + undone) / 4;
      work.energy.wall_work += impulse * twice_mean / 2;
      work.power.wall_work += impulse / kick_ * speed;
    }
    work.impulse[held.wall].add(place, given);
  }
}

template <class T, int D>
void BoundaryWork<T, D>::end_motion(int block, const EnergyBudget& power) {
  add(work_[block].energy, power, kick_ / 2);
  add(work_[block].power, power);
}

template <class T, int D>
void BoundaryWork<T, D>::fold(double inertia, std::optional<double> damped) {
  double acted_on = damped.value_or(inertia);
  for (const BlockWork& work : work_) {
    add(state_.energy, work.energy);
    add(state_.power, work.power);
    for (std::size_t w = 0; w < work.impulse.size(); ++w) {
      state_.wall_impulse[w].add(work.impulse[w], 1);
      state_.wall_force[w].add(work.impulse[w], 1 / kick_);
    }
    if (damped) acted_on -= work.undamped;
  }
  const double rate = state_.clock.damping * state_.clock.mass_scaling;
  state_.power.damping = rate * inertia;
  state_.energy.damping += kick_ * rate * acted_on;
}

template class BoundaryWork<double, 2>;
template class BoundaryWork<double, 3>;
template class BoundaryWork<float, 2>;
template class BoundaryWork<float, 3>;

}  // namespace pliant::undeformed
