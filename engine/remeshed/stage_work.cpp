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
  work_.assign(state_.blocks.size(), {});
  sticks_.assign(state_.blocks.size(), 0);
  for (int stage = 0; stage < 4; ++stage) {
    boundary_values_[stage].evaluate(state_.boundaries,
                                     state_.clock.time + stage_time[stage] * time_step);
    boundary_values_[stage].move_walls(state_.remeshed_poses);
  }
  particles_.prepare(time_step);
  walls_.prepare(time_step, boundary_values_);
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
  const Surroundings<D> now = around(stage);
  WallWork<T, D> of_walls = walls_.of_block(block, stage, now, work_[block].wall_work);
  fill(block, stage, body.neighbours.are_listed ? WhichGhosts::all : WhichGhosts::reached,
       &of_walls);
  drift_ghosts<T, D>(body, local, stage, now.values, settings_.ghosts, kernels_);
  if (add_impulse<T, D>(body, local, stage, now, stage_weight[stage] * time_step_, kernels_,
                        walls_.pushes(block), walls_.impulse(block), work_[block])) {
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
  walls_.begin(block, stage, loads.force);
  results_[block] = particles_.advance(block, stage);
  walls_.end(block, stage);
  keep_on_fits(body, local, stage, time_step_, state_.boundaries);
  if (reads_volumes(settings_)) copy_ghost_volumes(body, local, stage);
}

template <class T, int D>
void StageWork<T, D>::fold() {
  for (const EnergyBudget& work : work_) add(state_.energy, work);
  walls_.fold(particles_.body_forces());
  particles_.fold();
  results_.fold(state_.blocks);
}

template class StageWork<double, 2>;
template class StageWork<double, 3>;
template class StageWork<float, 2>;
template class StageWork<float, 3>;

}  // namespace pliant::remeshed
