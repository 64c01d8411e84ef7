#include "engine/remeshed/stage_work.hpp"

#include <algorithm>

#include "engine/remeshed/contact/wall_contact.hpp"
#include "engine/remeshed/ghosts/surface_records.hpp"
#include "engine/remeshed/images.hpp"
#include "engine/remeshed/pair_stress.hpp"
#include "engine/remeshed/runge_kutta.hpp"

namespace pliant::remeshed {

template <class T, int D>
void StageWork<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  impulse_.assign(state_.blocks.size() * state_.boundaries.walls.size(), {});
  for (int stage = 0; stage < 4; ++stage) {
    boundary_values_[stage].evaluate(state_.boundaries,
                                     state_.clock.time + stage_time[stage] * time_step);
  }
  particles_.prepare(time_step);
}

template <class T, int D>
void StageWork<T, D>::copy_image_positions(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  copy_image_drift(body, local, stage);
}

template <class T, int D>
void StageWork<T, D>::copy_image_states(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  copy_images(body, local, stage);
}

template <class T, int D>
void StageWork<T, D>::write_records(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  write_surface_records(body, local, stage, kernels_);
}

template <class T, int D>
void StageWork<T, D>::decide_wall_contact(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  decide_contact(body, local, state_.boundaries, boundary_values_[stage], kernels_);
}

template <class T, int D>
void StageWork<T, D>::fill(int block, int stage, WhichGhosts which) {
  const auto [body, local] = state_.owner(block);
  fill_ghosts<T, D>(body, local, stage, stage % 2, which, state_.boundaries,
                    boundary_values_[stage], settings_.ghosts, kernels_);
}

template <class T, int D>
void StageWork<T, D>::fill_all_ghosts(int block, int stage) {
  fill(block, stage, WhichGhosts::all);
}

// Ghosts that no stencil reaches only have to come along until the next remeshing. Neighbour lists
// may hold them too, and then their stress is read; where they drift to must not depend on that.
template <class T, int D>
void StageWork<T, D>::fill_reached_ghosts(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  fill(block, stage, body.neighbours.are_listed ? WhichGhosts::all : WhichGhosts::reached);
  drift_ghosts<T, D>(body, local, stage, settings_.ghosts, kernels_);
  Point<D>* impulse = impulse_.data() + block * state_.boundaries.walls.size();
  add_impulse<T, D>(body, local, state_.boundaries, boundary_values_[stage],
                    stage_weight[stage] * time_step_, kernels_, impulse);
}

template <class T, int D>
void StageWork<T, D>::find_pair_stress(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  remeshed::find_pair_stress<T, D>(body, local, stage, settings_.discretisation.artificial_stress);
}

template <class T, int D>
void StageWork<T, D>::fold() {
  result_ = {0, 0, -1};
  failed_block_ = -1;
  strain_rates_.assign(state_.bodies.size(), 0);
  const std::size_t walls = state_.wall_impulse.size();
  for (std::size_t i = 0; i < impulse_.size(); ++i) {
    for (int a = 0; a < D; ++a) state_.wall_impulse[i % walls][a] += impulse_[i][a];
  }
  for (std::size_t b = 0; b < results_.size(); ++b) {
    result_.strain_rate = std::max(result_.strain_rate, results_[b].strain_rate);
    result_.wave_speed = std::max(result_.wave_speed, results_[b].wave_speed);
    double& of_body = strain_rates_[state_.blocks[b].body];
    of_body = std::max(of_body, results_[b].strain_rate);
    if (results_[b].non_finite >= 0 && failed_block_ < 0) {
      result_.non_finite = results_[b].non_finite;
      failed_block_ = static_cast<int>(b);
    }
  }
}

template class StageWork<double, 2>;
template class StageWork<double, 3>;

}  // namespace pliant::remeshed
