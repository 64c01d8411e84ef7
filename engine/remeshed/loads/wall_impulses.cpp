#include "engine/remeshed/loads/wall_impulses.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/runge_kutta.hpp"

namespace pliant::remeshed {

namespace {

/// [wall] whether measurements of one of these kinds are of it.
template <int D>
std::vector<char> measured_walls(const Boundaries<D>& boundaries, const Case& settings,
                                 std::initializer_list<MeasurementCase::Kind> kinds) {
  std::vector<char> measured(boundaries.walls.size(), 0);
  for (const MeasurementCase& m : settings.measurements) {
    if (std::ranges::find(kinds, m.kind) != kinds.end()) {
      measured[boundaries.wall_of[m.boundary]] = 1;
    }
  }
  return measured;
}

template <int D>
std::vector<char> walls_with_moments(const Boundaries<D>& boundaries, const Case& settings) {
  auto walls = measured_walls(boundaries, settings, {MeasurementCase::Kind::wall_moment});
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (boundaries.walls[w].turns()) walls[w] = 1;
  }
  return walls;
}

}  // namespace

template <class T, int D>
WallImpulses<T, D>::WallImpulses(State<T, D>& state, const Case& settings)
    : state_(state),
      is_measured_(
          measured_walls(state.boundaries, settings,
                         {MeasurementCase::Kind::wall_force, MeasurementCase::Kind::wall_moment})),
      has_moment_(walls_with_moments(state.boundaries, settings)),
      have_moments_(std::ranges::find(has_moment_, 1) != has_moment_.end()),
      lone_walls_(state, settings, is_measured_, has_moment_) {}

template <class T, int D>
void WallImpulses<T, D>::prepare(double time_step, std::span<const BoundaryValues<D>> values) {
  time_step_ = time_step;
  values_ = values;
  const std::size_t blocks = state_.blocks.size();
  impulse_.assign(blocks * walls(), {});
  if (have_moments_) push_.assign(blocks * walls(), {});
  shares_.resize(blocks);
  // Walls at rest do no work, and they have many ghosts; skipping them saves time.
  is_watched_ = is_measured_;
  for (std::size_t w = 0; w < walls(); ++w) {
    const auto is_at_rest = [w](const BoundaryValues<D>& at) {
      return at.wall_motion[w].is_at_rest();
    };
    if (!std::ranges::all_of(values, is_at_rest)) is_watched_[w] = 1;
    if (!state_.boundaries.walls[w].is_attached()) is_watched_[w] = 0;
  }
  for (int a = 0; a < D; ++a) {
    for (const int wall : lone_walls_.together_along(a)) is_watched_[wall] = 1;
  }
  const auto is_watched = [this](int wall) { return wall >= 0 && is_watched_[wall] != 0; };
  needs_momentum_ =
      lone_walls_.are_any_together() || std::ranges::any_of(lone_walls_.along(), is_watched);
  if (needs_momentum_) lone_walls_.prepare(time_step);
  for (std::size_t w = 0; w < walls(); ++w) {
    const bool by_ghosts = has_moment_[w] != 0 && !lone_walls_.have_moment_of(static_cast<int>(w));
    if (!by_ghosts && lone_walls_.have_all_of(static_cast<int>(w))) is_watched_[w] = 0;
  }
}

template <class T, int D>
WallWork<T, D> WallImpulses<T, D>::of_block(int block, int stage, const Surroundings<D>& around,
                                            double& work) {
  const auto [body, local] = state_.owner(block);
  std::vector<WallShare>& shares = shares_[block];
  if (stage == 0) find_wall_shares<T, D>(body, local, around.boundaries, is_watched_, shares);
  return {body,
          body.population.ghosts[local],
          stage,
          around,
          stage_weight[stage] * time_step_,
          shares,
          lone_walls_.along(),
          pushes(block),
          impulse(block),
          work};
}

template <class T, int D>
std::span<WallPush<D>> WallImpulses<T, D>::pushes(int block) {
  if (!have_moments_) return {};
  return {push_.data() + block * walls(), walls()};
}

template <class T, int D>
void WallImpulses<T, D>::begin(int block, int stage, const Wrench<D>& force_of_loads) {
  if (needs_momentum_) lone_walls_.begin(block, stage, force_of_loads);
}

template <class T, int D>
void WallImpulses<T, D>::end(int block, int stage) {
  if (needs_momentum_) lone_walls_.end(block, stage);
}

template <class T, int D>
void WallImpulses<T, D>::fold(const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces) {
  whole_.assign(walls(), {});
  for (std::size_t i = 0; i < impulse_.size(); ++i) {
    for (int a = 0; a < D; ++a) whole_[i % walls()][a] += impulse_[i][a];
  }
  Wrench<D> by_momentum;
  if (needs_momentum_) {
    by_momentum = lone_walls_.impulse(body_forces);
    add_lone_walls(by_momentum.force);
  }
  for (std::size_t w = 0; w < walls(); ++w) {
    for (int a = 0; a < D; ++a) state_.wall_impulse[w].force[a] += whole_[w][a];
  }
  if (have_moments_) add_moments(by_momentum.moment);
}

template <class T, int D>
void WallImpulses<T, D>::add_lone_walls(const Point<D>& impulse) {
  for (int a = 0; a < D; ++a) {
    const int wall = lone_walls_.along()[a];
    if (wall >= 0) add_along(a, wall, impulse[a]);
    if (!lone_walls_.together_along(a).empty()) share_rest(a, impulse[a]);
  }
}

// What the forces of several walls by (RP.65) lack of their sum by (RP.105), in proportion to them.
// Where some have edges, the others are right.
template <class T, int D>
void WallImpulses<T, D>::share_rest(int axis, double impulse) {
  const std::vector<int>& acting = lone_walls_.together_along(axis);
  const auto has_edges = [this](int wall) { return lone_walls_.has_edges(wall); };
  const bool any_has_edges = std::ranges::any_of(acting, has_edges);
  double rest = impulse, size = 0;
  std::vector<double> weight(acting.size(), 0);
  for (std::size_t k = 0; k < acting.size(); ++k) {
    const double given = whole_[acting[k]][axis];
    rest -= given;
    if (!any_has_edges || has_edges(acting[k])) weight[k] = std::abs(given);
    size += weight[k];
  }
  if (size == 0) return;
  for (std::size_t k = 0; k < acting.size(); ++k) {
    add_along(axis, acting[k], rest * weight[k] / size);
  }
}

template <class T, int D>
void WallImpulses<T, D>::add_along(int axis, int wall, double impulse) {
  whole_[wall][axis] += impulse;
  for (std::size_t stage = 0; stage < values_.size(); ++stage) {
    const double velocity = values_[stage].wall_motion[wall].velocity[axis];
    state_.energy.wall_work += stage_weight[stage] * impulse * velocity;
  }
}

// (RP.115). The work of the centres is known; that of the rotation about them is added.
template <class T, int D>
void WallImpulses<T, D>::add_moments(const Vector& by_momentum) {
  for (std::size_t w = 0; w < walls(); ++w) {
    if (has_moment_[w] == 0) continue;
    WallPush<D> push;
    for (std::size_t i = w; i < push_.size(); i += walls()) push.add(push_[i]);
    Wrench<D> given = push.completed(whole_[w]);
    if (needs_momentum_ && lone_walls_.have_moment_of(static_cast<int>(w))) {
      given.moment = by_momentum;
    }
    for (int a = 0; a < 3; ++a) state_.wall_impulse[w].moment[a] += given.moment[a];
    const Wall<D>& wall = state_.boundaries.walls[w];
    if (!wall.turns()) continue;
    const Vector about_centre = given.moment_about(wall.centre());
    for (std::size_t stage = 0; stage < values_.size(); ++stage) {
      for (int a = 0; a < 3; ++a) {
        state_.energy.wall_work +=
            stage_weight[stage] * values_[stage].wall_motion[w].spin[a] * about_centre[a];
      }
    }
  }
}

template class WallImpulses<double, 2>;
template class WallImpulses<double, 3>;
template class WallImpulses<float, 2>;
template class WallImpulses<float, 3>;

}  // namespace pliant::remeshed
