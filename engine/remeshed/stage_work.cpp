#include "engine/remeshed/stage_work.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/contact/wall_contact.hpp"
#include "engine/remeshed/ghosts/surface_records.hpp"
#include "engine/remeshed/loads/loaded_surface.hpp"
#include "engine/remeshed/loads/shear_patches.hpp"
#include "engine/remeshed/loads/shear_stress.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/setup/images.hpp"

namespace pliant::remeshed {

namespace {

/// Copies the volume of ghosts, constant within a step, to the next stage, whose gradients read it,
/// (RP.19).
template <class T, int D>
void copy_ghost_volumes(Body<T, D>& body, int block, int stage) {
  const T* volume = body.stage[buffer_of(stage)].get(Field::volume);
  T* next = body.stage[buffer_after(stage)].get(Field::volume);
  for (const std::int32_t slot : body.population.ghosts[block].slot) next[slot] = volume[slot];
}

}  // namespace

template <class T, int D>
void StageWork<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  impulse_.assign(state_.blocks.size() * state_.boundaries.walls.size(), {});
  work_.assign(state_.blocks.size(), {});
  sticks_.assign(state_.blocks.size(), 0);
  wall_shares_.resize(state_.blocks.size());
  for (int stage = 0; stage < 4; ++stage) {
    boundary_values_[stage].evaluate(state_.boundaries,
                                     state_.clock.time + stage_time[stage] * time_step);
  }
  particles_.prepare(time_step);
  // Walls at rest do no work, and they have many ghosts; skipping them saves time.
  is_watched_ = is_measured_;
  for (const BoundaryValues<D>& values : boundary_values_) {
    for (std::size_t w = 0; w < is_watched_.size(); ++w) {
      if (values.wall_velocity[w] != Point<D>{}) is_watched_[w] = 1;
    }
  }
  for (std::size_t w = 0; w < is_watched_.size(); ++w) {
    if (!state_.boundaries.walls[w].is_attached()) is_watched_[w] = 0;
  }
  for (int a = 0; a < D; ++a) {
    for (const int wall : lone_walls_.together_along(a)) is_watched_[wall] = 1;
  }
  const auto is_watched = [this](int wall) { return wall >= 0 && is_watched_[wall] != 0; };
  needs_momentum_ =
      lone_walls_.are_any_together() || std::ranges::any_of(lone_walls_.along(), is_watched);
  if (needs_momentum_) lone_walls_.prepare(time_step);
  for (std::size_t w = 0; w < is_watched_.size(); ++w) {
    if (lone_walls_.have_all_of(static_cast<int>(w))) is_watched_[w] = 0;
  }
}

template <class T, int D>
std::vector<char> StageWork<T, D>::measured_walls(const Case& settings) {
  const Boundaries<D> boundaries(settings.boundaries);
  std::vector<char> measured(boundaries.walls.size(), 0);
  for (const MeasurementCase& m : settings.measurements) {
    if (m.kind == MeasurementCase::Kind::wall_force) measured[boundaries.wall_of[m.boundary]] = 1;
  }
  return measured;
}

template <class T, int D>
void StageWork<T, D>::copy_image_positions(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  copy_image_drift(body, local, stage);
}

template <class T, int D>
void StageWork<T, D>::copy_image_states(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  copy_images(body, local, stage, reads_volumes(settings_));
}

template <class T, int D>
void StageWork<T, D>::write_records(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  const Slopes slopes = slopes_at(stage, time_step_, damps_adaptively(settings_));
  write_surface_records(body, local, stage, slopes, kernels_);
}

template <class T, int D>
void StageWork<T, D>::decide_wall_contact(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  decide_contact(body, local, around(stage), kernels_);
}

template <class T, int D>
void StageWork<T, D>::release_wall_contact(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  release_contact(body, local, around(stage), kernels_);
}

template <class T, int D>
void StageWork<T, D>::fill(int block, int stage, WhichGhosts which, WallWork<T, D>* work) {
  const auto [body, local] = state_.owner(block);
  fill_ghosts<T, D>(body, local, stage, stage % 2, which, around(stage), settings_.ghosts, kernels_,
                    work);
}

template <class T, int D>
void StageWork<T, D>::fill_all_ghosts(int block, int stage) {
  fill(block, stage, WhichGhosts::all, nullptr);
}

// Ghosts outside every stencil only have to drift along until the next remeshing. Neighbour lists
// may hold them, and then their stress is read as well. Their drift must not depend on that.
template <class T, int D>
void StageWork<T, D>::fill_reached_ghosts(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  const double duration = stage_weight[stage] * time_step_;
  Point<D>* impulse = impulse_.data() + block * state_.boundaries.walls.size();
  const Surroundings<D> now = around(stage);
  std::vector<WallShare>& shares = wall_shares_[block];
  if (stage == 0) find_wall_shares<T, D>(body, local, now.boundaries, is_watched_, shares);
  WallWork<T, D> of_walls(body, body.population.ghosts[local], stage, now, duration, shares,
                          lone_walls_.along(), impulse, work_[block].wall_work);
  fill(block, stage, body.neighbours.are_listed ? WhichGhosts::all : WhichGhosts::reached,
       &of_walls);
  drift_ghosts<T, D>(body, local, stage, now.values, settings_.ghosts, kernels_);
  if (add_impulse<T, D>(body, local, stage, now, duration, kernels_, impulse, work_[block])) {
    sticks_[block] = 1;
  }
}

template <class T, int D>
void StageWork<T, D>::evaluate_shear_forces(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  evaluate_shear(body, local, stage, boundary_values_[stage]);
}

template <class T, int D>
void StageWork<T, D>::take_shear_stresses(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  take_shear_stress(body, local, stage);
}

template <class T, int D>
void StageWork<T, D>::give_back_shear_stresses(int block) {
  const auto [body, local] = state_.owner(block);
  give_back_shear_stress(body, local);
}

template <class T, int D>
void StageWork<T, D>::advance(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  const LoadsOnBlock<D> loads = loads_on_block<T, D>(body, local, stage, boundary_values_[stage]);
  work_[block].load_work += stage_weight[stage] * time_step_ * loads.power;
  if (needs_momentum_) lone_walls_.begin(block, stage, loads.force);
  results_[block] = particles_.advance(block, stage);
  if (needs_momentum_) lone_walls_.end(block, stage);
  keep_on_fits(body, local, stage, time_step_, state_.boundaries);
  if (reads_volumes(settings_)) copy_ghost_volumes(body, local, stage);
}

template <class T, int D>
void StageWork<T, D>::fold() {
  const std::size_t walls = state_.wall_impulse.size();
  for (std::size_t i = 0; i < impulse_.size(); ++i) {
    for (int a = 0; a < D; ++a) state_.wall_impulse[i % walls][a] += impulse_[i][a];
  }
  for (const EnergyBudget& work : work_) add(state_.energy, work);
  if (needs_momentum_) add_lone_walls();
  particles_.fold();
  results_.fold(state_.blocks);
}

template <class T, int D>
void StageWork<T, D>::add_lone_walls() {
  const Point<D> impulse = lone_walls_.impulse(particles_.body_force_impulse());
  for (int a = 0; a < D; ++a) {
    const int wall = lone_walls_.along()[a];
    if (wall >= 0) add_impulse_along(a, wall, impulse[a]);
    if (!lone_walls_.together_along(a).empty()) share_rest(a, impulse[a]);
  }
}

// What the forces of several walls by (RP.65) lack of their sum by (RP.105), in proportion to them.
// Where some have edges, the others are right.
template <class T, int D>
void StageWork<T, D>::share_rest(int axis, double impulse) {
  const std::vector<int>& acting = lone_walls_.together_along(axis);
  const std::size_t walls = state_.wall_impulse.size();
  std::vector<double> given(acting.size(), 0);
  for (std::size_t first = 0; first < impulse_.size(); first += walls) {
    for (std::size_t k = 0; k < acting.size(); ++k) given[k] += impulse_[first + acting[k]][axis];
  }
  const auto has_edges = [this](int wall) { return lone_walls_.has_edges(wall); };
  const bool any_has_edges = std::ranges::any_of(acting, has_edges);
  double rest = impulse, size = 0;
  std::vector<double> weight(acting.size(), 0);
  for (std::size_t k = 0; k < acting.size(); ++k) {
    rest -= given[k];
    if (!any_has_edges || has_edges(acting[k])) weight[k] = std::abs(given[k]);
    size += weight[k];
  }
  if (size == 0) return;
  for (std::size_t k = 0; k < acting.size(); ++k) {
    add_impulse_along(axis, acting[k], rest * weight[k] / size);
  }
}

template <class T, int D>
void StageWork<T, D>::add_impulse_along(int axis, int wall, double impulse) {
  state_.wall_impulse[wall][axis] += impulse;
  for (int stage = 0; stage < 4; ++stage) {
    const double velocity = boundary_values_[stage].wall_velocity[wall][axis];
    state_.energy.wall_work += stage_weight[stage] * impulse * velocity;
  }
}

template class StageWork<double, 2>;
template class StageWork<double, 3>;
template class StageWork<float, 2>;
template class StageWork<float, 3>;

}  // namespace pliant::remeshed
