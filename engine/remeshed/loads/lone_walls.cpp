#include "engine/remeshed/loads/lone_walls.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/loads/loaded_surface.hpp"
#include "engine/remeshed/runge_kutta.hpp"

namespace pliant::remeshed {

namespace {

/// Whether a wall is a plane across `axis` along which bodies slip.
bool is_slip_plane(const BoundaryCase& wall, int axis) {
  constexpr double aligned = 1 - 1e-12;
  return wall.kind == BoundaryCase::Kind::slip_wall &&
         wall.geometry.kind == Shape::Kind::half_space &&
         std::abs(wall.geometry.normal[axis]) > aligned;
}

/// Whether a wall can act on bodies along `axis`.
bool can_act_along(const BoundaryCase& wall, int axis) {
  for (int other = 0; other < 3; ++other) {
    if (other != axis && is_slip_plane(wall, other)) return false;
  }
  return true;
}

}  // namespace

template <class T, int D>
LoneWalls<T, D>::LoneWalls(State<T, D>& state, const Case& settings)
    : state_(state), acts_(state.boundaries.walls.size()) {
  along_.fill(-1);
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const int wall = state.boundaries.wall_of[b];
    for (int a = 0; wall >= 0 && a < D; ++a) {
      acts_[wall][a] = can_act_along(settings.boundaries[b], a);
    }
  }
  if (state.boundaries.have_contact() || !settings.contacts.empty()) return;
  for (int a = 0; a < D; ++a) {
    const auto acts = [a](const std::array<bool, D>& wall) { return wall[a]; };
    if (std::ranges::count_if(acts_, acts) != 1) continue;
    along_[a] = static_cast<int>(std::ranges::find_if(acts_, acts) - acts_.begin());
  }
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
void LoneWalls<T, D>::begin(int block, int stage, const BoundaryValues<D>& values) {
  const auto owner = state_.owner(block);
  const Body<T, D>& body = owner.body;
  Change& change = change_[block];
  const PlaceVector<D> force = force_of_loads<T, D>(body, owner.block, stage, values);
  for (int a = 0; a < D; ++a) change.by_loads[a] += stage_weight[stage] * time_step_ * force[a];
  if (stage > 0) return;
  add(block, body.stage[0], -1, change);
  change.is_held = std::ranges::any_of(body.population.ghosts[owner.block].wall,
                                       [](int wall) { return wall >= 0; });
}

template <class T, int D>
void LoneWalls<T, D>::end(int block, int stage) {
  if (stage < 3) return;
  change_[block].mass = 0;
  add(block, state_.owner(block).body.stage[buffer_after(stage)], 1, change_[block]);
}

template <class T, int D>
void LoneWalls<T, D>::add(int block, const FieldStore<T, D>& fields, double sign,
                          Change& sum) const {
  const auto owner = state_.owner(block);
  const Body<T, D>& body = owner.body;
  const T* mass = body.stage[0].get(Field::mass);
  const Layout<D>& layout = body.population.layout;
  layout.for_each_slot(layout.blocks()[owner.block], [&](std::int64_t p, const Cell<D>&) {
    if (body.population.kind[p] != Kind::interior) return;
    sum.mass += mass[p];
    for (int a = 0; a < D; ++a) {
      sum.momentum[a] += sign * mass[p] * fields.get(Field::velocity, a)[p];
    }
  });
}

// The particles of a body may have more mass together than the body, whose surface cuts their
// cells.
template <class T, int D>
Point<D> LoneWalls<T, D>::impulse(const std::vector<Point<D>>& of_body_forces) const {
  std::vector<Change> of_body(state_.bodies.size());
  for (std::size_t b = 0; b < change_.size(); ++b) {
    Change& sum = of_body[state_.blocks[b].body];
    sum.mass += change_[b].mass;
    sum.is_held = sum.is_held || change_[b].is_held;
    for (int a = 0; a < D; ++a) {
      sum.momentum[a] += change_[b].momentum[a] - of_body_forces[b][a];
      sum.by_loads[a] += change_[b].by_loads[a];
    }
  }
  Point<D> impulse = {};
  for (std::size_t b = 0; b < of_body.size(); ++b) {
    const Change& change = of_body[b];
    if (!change.is_held) continue;
    const double mass = state_.motion_budgets[b].mass;
    const double share = mass > 0 ? mass / change.mass : 1;
    for (int a = 0; a < D; ++a) impulse[a] += share * change.momentum[a] - change.by_loads[a];
  }
  return impulse;
}

template class LoneWalls<double, 2>;
template class LoneWalls<double, 3>;
template class LoneWalls<float, 2>;
template class LoneWalls<float, 3>;

}  // namespace pliant::remeshed
