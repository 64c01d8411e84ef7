#include "engine/remeshed/state/state_copy.hpp"

#include <algorithm>

namespace pliant::remeshed {

namespace {

/// Calls f(number, buffer) for the arrays of slots that a step changes.
template <class B, class F>
void for_each_changed(B& body, F&& f) {
  std::size_t number = 0;
  for (const Declaration& field : state_fields) {
    if (!is_evolving(field) && field.field != Field::memory_pressure) continue;
    for (auto& component : body.stage[0][field.field]) f(number++, component);
  }
  for (auto& component : body.stress) f(number++, component);
}

}  // namespace

template <class T, int D>
void StateCopy<T, D>::keep(const State<T, D>& state) {
  clock_ = state.clock;
  energy_ = state.energy;
  wall_pose_.clear();
  for (const Wall<D>& wall : state.boundaries.walls) wall_pose_.push_back(wall.pose());
  wall_impulse_ = state.wall_impulse;
  contact_impulse_ = state.contact_impulse;
  momentum_budgets_ = state.momentum_budgets;
  motion_budgets_ = state.motion_budgets;
  bodies_.resize(state.bodies.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body<T, D>& body = state.bodies[b];
    OfBody& copy = bodies_[b];
    const std::int64_t slots = body.population.layout.slots();
    for_each_changed(body, [&](std::size_t number, const Buffer<T>& values) {
      if (copy.arrays.size() == number) copy.arrays.emplace_back();
      copy.arrays[number].assign(values.get(), values.get() + slots);
    });
    const Population<T, D>& population = body.population;
    copy.kind.assign(population.kind.get(), population.kind.get() + slots);
    copy.pack_state.assign(population.pack_state.get(),
                           population.pack_state.get() + slots / Layout<D>::pack);
    copy.active.resize(population.ghosts.size());
    copy.lasting.resize(population.ghosts.size());
    for (std::size_t k = 0; k < copy.active.size(); ++k) {
      copy.active[k] = population.ghosts[k].active;
      copy.lasting[k] = population.ghosts[k].lasting;
    }
    copy.strain = body.neighbours.strain;
    copy.strain_rate = body.neighbours.strain_rate;
  }
}

template <class T, int D>
void StateCopy<T, D>::put_back(State<T, D>& state) const {
  state.clock = clock_;
  state.energy = energy_;
  for (std::size_t w = 0; w < wall_pose_.size(); ++w) {
    state.boundaries.walls[w].restore(wall_pose_[w]);
  }
  state.wall_impulse = wall_impulse_;
  state.contact_impulse = contact_impulse_;
  state.momentum_budgets = momentum_budgets_;
  state.motion_budgets = motion_budgets_;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body<T, D>& body = state.bodies[b];
    const OfBody& copy = bodies_[b];
    for_each_changed(body, [&](std::size_t number, Buffer<T>& values) {
      std::copy(copy.arrays[number].begin(), copy.arrays[number].end(), values.get());
    });
    Population<T, D>& population = body.population;
    std::copy(copy.kind.begin(), copy.kind.end(), population.kind.get());
    std::copy(copy.pack_state.begin(), copy.pack_state.end(), population.pack_state.get());
    for (std::size_t k = 0; k < copy.active.size(); ++k) {
      population.ghosts[k].active = copy.active[k];
      population.ghosts[k].lasting = copy.lasting[k];
    }
    body.neighbours.strain = copy.strain;
    body.neighbours.strain_rate = copy.strain_rate;
  }
}

template <class T, int D>
std::size_t StateCopy<T, D>::bytes() const {
  std::size_t sum = 0;
  for (const OfBody& copy : bodies_) {
    for (const std::vector<T>& values : copy.arrays) sum += values.capacity() * sizeof(T);
    sum += copy.kind.capacity() * sizeof(Kind) + copy.pack_state.capacity() * sizeof(PackState);
  }
  return sum;
}

template class StateCopy<double, 2>;
template class StateCopy<double, 3>;
template class StateCopy<float, 2>;
template class StateCopy<float, 3>;

}  // namespace pliant::remeshed
