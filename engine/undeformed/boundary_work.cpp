#include "engine/undeformed/boundary_work.hpp"

#include <algorithm>
#include <cmath>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

namespace {

/// The part of `v` that a wall prescribes: at a slip wall, the normal part.
template <int D>
Point<D> held_part(const ConstrainedParticle<D>& held, const Point<D>& v) {
  if (held.normal == Point<D>{}) return v;
  const double along = dot<D>(v, held.normal);
  Point<D> part;
  for (int a = 0; a < D; ++a) part[a] = along * held.normal[a];
  return part;
}

template <int D>
Point<D> mean_velocity(Point<D> shift, double length) {
  for (double& component : shift) component /= length;
  return shift;
}

}  // namespace

template <class T, int D>
void BoundaryWork<T, D>::add_blocks(const Body<T, D>& body) {
  for (const auto& held : body.held) {
    BlockWork& work = work_.emplace_back();
    work.impulse.resize(state_.boundaries.walls.size());
    work.before.resize(held.size());
    work.start.resize(held.size());
  }
}

// If particles move at their new velocity during the whole step, that velocity is the mean of the
// step; otherwise it is that of its end.
template <class T, int D>
void BoundaryWork<T, D>::prepare(const Times& times) {
  times_ = times;
  walls_.clear();
  for (const Wall<D>& wall : state_.boundaries.walls) {
    walls_.push_back({wall.step(times.begin, times.length), std::nullopt});
    if (times.drift < times.length)
      walls_.back().velocity = wall.motion(times.begin + times.length);
  }
  state_.power = {};
  std::fill(state_.wall_force.begin(), state_.wall_force.end(), Wrench<D>{});
}

template <class T, int D>
void BoundaryWork<T, D>::begin_motion(int block, const Body<T, D>& body, int local,
                                      const EnergyBudget& power) {
  BlockWork& work = work_[block];
  work.energy = work.power = work.at_end = {};
  work.undamped = 0;
  work.inertia.reset();
  std::fill(work.impulse.begin(), work.impulse.end(), Wrench<D>{});
  add(work.energy, power, times_.kick / 2);
  const auto& held = body.held[local];
  for (std::size_t i = 0; i < held.size(); ++i) {
    for (int a = 0; a < D; ++a) {
      const double u = body.velocity[a][held[i].slot];
      work.before[i][a] = u;
      work.start[i][a] = body.displacement[a][held[i].slot] - (times_.length - times_.drift) * u;
    }
  }
}

template <class T, int D>
void BoundaryWork<T, D>::hold(int block, Body<T, D>& body, int local,
                              std::array<Buffer<T>, D>& displacement) {
  BlockWork& work = work_[block];
  const double inertia = state_.clock.inertia(times_.kick);
  const auto& particles = body.held[local];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const ConstrainedParticle<D>& held = particles[i];
    const Motion& wall = walls_[held.wall];
    const Point<D> shift = wall.step.shift_of(held.start);
    const Point<D> velocity =
        wall.velocity ? wall.velocity->of(held.start) : mean_velocity<D>(shift, times_.length);
    Point<D> excess, astray;
    for (int a = 0; a < D; ++a) {
      excess[a] = body.velocity[a][held.slot] - velocity[a];
      astray[a] = displacement[a][held.slot] - work.start[i][a] - shift[a];
    }
    const Point<D> undone = held_part<D>(held, excess), moved_back = held_part<D>(held, astray);
    Point<D> place = held.start, given;
    for (int a = 0; a < D; ++a) {
      body.velocity[a][held.slot] -= undone[a];
      displacement[a][held.slot] -= moved_back[a];
      const double impulse = -inertia * body.mass[held.slot] * undone[a];
      place[a] += displacement[a][held.slot];
      given[a] = impulse;
      const double speed = body.velocity[a][held.slot], twice_mean = work.before[i][a] + speed;
      work.undamped += body.mass[held.slot] * undone[a] * (2 * twice_mean + undone[a]) / 4;
      work.energy.wall_work += impulse * twice_mean / 2;
      work.power.wall_work += impulse / times_.kick * speed;
    }
    work.impulse[held.wall].add(place, given);
  }
}

template <class T, int D>
void BoundaryWork<T, D>::end_motion(int block, const EnergyBudget& power) {
  work_[block].at_end = power;
}

template <class T, int D>
void BoundaryWork<T, D>::fold(int block, double inertia, double damped) {
  const BlockWork& work = work_[block];
  add(state_.energy, work.energy);
  add(state_.energy, work.at_end, times_.kick / 2);
  add(state_.power, work.power);
  add(state_.power, work.at_end);
  for (std::size_t w = 0; w < work.impulse.size(); ++w) {
    state_.wall_impulse[w].add(work.impulse[w], 1);
    state_.wall_force[w].add(work.impulse[w], 1 / times_.kick);
  }
  const double acted_on = work.inertia
                              ? std::pow((std::sqrt(inertia) + std::sqrt(*work.inertia)) / 2, 2)
                              : damped - work.undamped;
  const double rate = state_.clock.damping * state_.clock.mass_scaling;
  state_.power.damping += rate * inertia;
  state_.energy.damping += times_.kick * rate * acted_on;
}

template <class T, int D>
void BoundaryWork<T, D>::after_contact(int block, const Body<T, D>& body, std::int64_t first,
                                       std::int64_t count) {
  if (state_.clock.damping == 0) return;
  double sum = 0;
  for (std::int64_t slot = first; slot < first + count; ++slot) {
    double square = 0;
    for (int a = 0; a < D; ++a) square += std::pow(double{body.velocity[a][slot]}, 2);
    sum += body.mass[slot] * square;
  }
  work_[block].inertia = sum;
}

template class BoundaryWork<double, 2>;
template class BoundaryWork<double, 3>;
template class BoundaryWork<float, 2>;
template class BoundaryWork<float, 3>;

}  // namespace pliant::undeformed
