#include "engine/remeshed/loads/lone_walls.hpp"

#include <algorithm>
#include <utility>

#include "engine/geometry/plane_across.hpp"
#include "engine/remeshed/runge_kutta.hpp"

namespace pliant::remeshed {

namespace {

/// Whether a wall can act on bodies along `axis`.
bool can_act_along(const BoundaryCase& wall, int axis) {
  if (wall.kind != BoundaryCase::Kind::slip_wall) return true;
  for (int other = 0; other < 3; ++other) {
    if (other != axis && is_plane_across(wall.geometry, other)) return false;
  }
  return true;
}

/// Sum m x cross u over the particles of a block [N m s], with velocities and places of two copies
/// of the body's state.
template <class T, int D>
Vector angular_momentum(const Body<T, D>& body, int block, const FieldStore<T, D>& state,
                        const FieldStore<T, D>& places) {
  const T* mass = body.stage[0].get(Field::mass);
  const Layout<D>& layout = body.population.layout;
  Wrench<D> sum;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (body.population.kind[p] != Kind::interior) return;
    Point<D> x = body.lattice.node(cell), momentum;
    for (int a = 0; a < D; ++a) {
      x[a] += places.get(Field::drift, a)[p];
      momentum[a] = double{mass[p]} * state.get(Field::velocity, a)[p];
    }
    sum.add(x, momentum);
  });
  return sum.moment;
}

}  // namespace

template <class T, int D>
LoneWalls<T, D>::LoneWalls(State<T, D>& state, const Case& settings,
                           const std::vector<char>& measured, const std::vector<char>& has_moment)
    : state_(state), acts_(state.boundaries.walls.size()), has_edges_(acts_.size(), 0) {
  along_.fill(-1);
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const int wall = state.boundaries.wall_of[b];
    if (wall < 0) continue;
    has_edges_[wall] = settings.boundaries[b].geometry.kind != Shape::Kind::half_space;
    for (int a = 0; a < D; ++a) {
      acts_[wall][a] = can_act_along(settings.boundaries[b], a);
    }
  }
  if (state.boundaries.have_contact() || !settings.contacts.empty()) return;
  const auto is_measured = [&measured](int wall) { return measured[wall] != 0; };
  for (int a = 0; a < D; ++a) {
    std::vector<int> acting;
    for (std::size_t wall = 0; wall < acts_.size(); ++wall) {
      if (acts_[wall][a]) acting.push_back(static_cast<int>(wall));
    }
    if (acting.size() == 1) {
      along_[a] = acting.front();
    } else if (std::ranges::any_of(acting, is_measured)) {
      together_[a] = std::move(acting);
    }
  }
  have_moments_ = along_[0] >= 0 && have_moment_of(along_[0]) && has_moment[along_[0]] != 0;
}

template <class T, int D>
bool LoneWalls<T, D>::have_all_of(int wall) const {
  for (int a = 0; a < D; ++a) {
    if (acts_[wall][a] && along_[a] != wall) return false;
  }
  return true;
}

template <class T, int D>
void LoneWalls<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  change_.assign(state_.blocks.size(), {});
}

template <class T, int D>
void LoneWalls<T, D>::begin(int block, int stage, const Wrench<D>& force_of_loads) {
  Change& change = change_[block];
  change.by_loads.add(force_of_loads, stage_weight[stage] * time_step_);
  if (stage > 0) return;
  const auto [body, local] = state_.owner(block);
  change.before = particle_momentum<T, D>(body, local, body.stage[0]);
  if (have_moments_) {
    change.turning_before = angular_momentum<T, D>(body, local, body.stage[0], body.stage[0]);
  }
  change.is_held =
      std::ranges::any_of(body.population.ghosts[local].wall, [](int wall) { return wall >= 0; });
}

template <class T, int D>
void LoneWalls<T, D>::end(int block, int stage) {
  if (stage < 3) return;
  const auto [body, local] = state_.owner(block);
  const FieldStore<T, D>& state = body.stage[buffer_after(stage)];
  change_[block].after = particle_momentum<T, D>(body, local, state);
  if (have_moments_) {
    change_[block].turning_after =
        angular_momentum<T, D>(body, local, state, body.stage[drift_buffer_after(stage)]);
  }
}

// The particles of a body may have more mass together than the body, whose surface cuts their
// cells.
template <class T, int D>
Wrench<D> LoneWalls<T, D>::impulse(
    const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces) const {
  struct OfBody {
    double mass = 0;
    Wrench<D> gained, by_loads;
    bool is_held = false;
  };
  std::vector<OfBody> of_body(state_.bodies.size());
  for (std::size_t b = 0; b < change_.size(); ++b) {
    const Change& change = change_[b];
    OfBody& sum = of_body[state_.blocks[b].body];
    sum.mass += change.after.mass;
    sum.is_held = sum.is_held || change.is_held;
    Wrench<D> gained = {change.after.momentum, change.turning_after}, by_field;
    for (int stage = 0; stage < 4; ++stage) {
      by_field.add(body_forces[b][stage].force, stage_weight[stage] * time_step_);
    }
    gained.add({change.before.momentum, change.turning_before}, -1);
    gained.add(by_field, -1);
    sum.gained.add(gained, 1);
    sum.by_loads.add(change.by_loads, 1);
  }
  Wrench<D> impulse;
  for (std::size_t b = 0; b < of_body.size(); ++b) {
    const OfBody& sum = of_body[b];
    if (!sum.is_held) continue;
    const double mass = state_.motion_budgets[b].mass;
    Wrench<D> by_walls;
    by_walls.add(sum.gained, mass > 0 ? mass / sum.mass : 1);
    by_walls.add(sum.by_loads, -1);
    impulse.add(by_walls, 1);
  }
  return impulse;
}

template class LoneWalls<double, 2>;
template class LoneWalls<double, 3>;
template class LoneWalls<float, 2>;
template class LoneWalls<float, 3>;

}  // namespace pliant::remeshed
