#include "engine/total_lagrangian/step.hpp"

#include <algorithm>

// A step of the total Lagrangian method: everything happens on the lattice of the undeformed body,
// whose particles keep their neighbours for ever.
//
//     pressure  the force on the surface inside each cell where a pressure acts      (TL.7)
//     traction  what it is to each particle                                          (TL.7)
//     stress    F at each stress point from the particles at its cell's corners,
//               stress, and the force that it puts on those corners                  (TL.2)-(TL.6)
//     motion    the particles' forces; velocity and displacement by central
//               differences with damping; walls hold what they touch                 (TL.5), (TL.8)
//
// One evaluation of the stress each step, and no state but displacement and velocity: F is a
// function of where the particles are, so that nothing creeps however long a load is held.
namespace pliant::total_lagrangian {

namespace {

using scheduler::Phase;
using scheduler::Reach;

enum Resource : scheduler::FieldId {
  displacement,
  velocity,
  patch_forces,
  tractions,
  internal_forces,
  results
};

}  // namespace

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::TotalLagrangianTable<T, D>& kernels)
    : state_(state), settings_(settings), kernels_(kernels) {}

template <class T, int D>
std::vector<std::string> Step<T, D>::resources() {
  return {"d", "u", "forces on patches", "tractions", "forces of stress points", "results"};
}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  stress_results_.assign(state_.blocks.size(), {0, -1});
  motion_results_.assign(state_.blocks.size(), {});
  using Access = scheduler::Access;
  const auto each = [this](const char* name, const std::vector<Access>& reads,
                           const std::vector<Access>& writes, auto run) -> Phase {
    return {.name = name, .reads = reads, .writes = writes, .run = [this, run](int block) {
              (this->*run)(block);
            }};
  };
  std::vector<Phase> phases;
  if (!state_.boundaries.pressures.empty()) {
    phases.push_back(each("pressure", {{displacement, Reach::neighbours}}, {{patch_forces}},
                          &Step::sum_patch_loads));
    phases.push_back(each("traction", {{patch_forces, Reach::neighbours}}, {{tractions}},
                          &Step::distribute_patch_loads));
  }
  phases.push_back(each("stress", {{displacement, Reach::neighbours}},
                        {{internal_forces}, {results}}, &Step::evaluate_stress));
  phases.push_back(each(
      "motion", {{internal_forces, Reach::neighbours}, {tractions}, {velocity}, {displacement}},
      {{velocity}, {displacement}, {results}}, &Step::move));
  return phases;
}

template <class T, int D>
void Step<T, D>::prepare(double time_step, bool examine) {
  time_step_ = time_step;
  examine_ = examine;
  const double t = state_.clock.time;
  pressure_.clear();
  for (const auto& pressure : state_.boundaries.pressures) pressure_.push_back(pressure.value(t));
  wall_velocity_.clear();
  for (const Wall<D>& wall : state_.boundaries.walls) {
    wall_velocity_.push_back(wall.velocity(t + time_step / 2));
  }
}

template <class T, int D>
StepResult Step<T, D>::fold() const {
  StepResult result;
  double stiffness = 0, inertia = 0;
  for (std::size_t b = 0; b < stress_results_.size(); ++b) {
    result.wave_speed = std::max(result.wave_speed, stress_results_[b].wave_speed);
    stiffness += motion_results_[b].stiffness;
    inertia += motion_results_[b].inertia;
    if (stress_results_[b].non_finite >= 0 && result.non_finite < 0) {
      result.non_finite = stress_results_[b].non_finite;
      result.failed_block = static_cast<int>(b);
    }
  }
  if (stiffness > 0 && inertia > 0) result.frequency2 = stiffness / (time_step_ * inertia);
  return result;
}

template <class T, int D>
void Step<T, D>::sum_patch_loads(int block) {
  const auto [body, local] = owner(block);
  for (int i = body.first_patch[local]; i < body.first_patch[local + 1]; ++i) {
    const SurfacePatch& patch = body.patches[i];
    Point<D> area = {};
    for (int k = patch.first_load; k < patch.first_load + patch.load_count; ++k) {
      const Point<D> whole = area_vector(body, body.facets[body.loads[k].facet]);
      for (int a = 0; a < D; ++a) area[a] += body.loads[k].share * whole[a];
    }
    for (int a = 0; a < D; ++a) body.patch_force[i][a] = -pressure_[patch.pressure] * area[a];
  }
}

template <class T, int D>
void Step<T, D>::distribute_patch_loads(int block) {
  const auto [body, local] = owner(block);
  const NodalLoads& nodal_loads = body.nodal_loads[local];
  for (std::size_t i = 0; i < nodal_loads.slot.size(); ++i) {
    Point<D> sum = {};
    for (std::int32_t k = nodal_loads.begin[i]; k < nodal_loads.begin[i + 1]; ++k) {
      for (int a = 0; a < D; ++a)
        sum[a] += nodal_loads.weight[k] * body.patch_force[nodal_loads.patch[k]][a];
    }
    for (int a = 0; a < D; ++a) body.traction[a][nodal_loads.slot[i]] = sum[a];
  }
}

template <class T, int D>
void Step<T, D>::evaluate_stress(int block) {
  const auto [body, local] = owner(block);
  const Block<D>& range = body.layout.blocks()[local];
  kernels::StressPoints<T, D> work = {};
  work.segments = body.layout.segments_of(range);
  work.segment_count = range.segment_count;
  work.spacing = static_cast<T>(body.lattice.spacing);
  work.hourglass = static_cast<T>(settings_.total_lagrangian.hourglass_stiffness);
  work.examine = examine_;
  work.material = body.material;
  work.fraction = body.fraction.get();
  work.displacement = body.displacement_view();
  for (int a = 0; a < D; ++a) {
    for (int m = 0; m < kernels::cell_modes<D>; ++m) work.force[a][m] = body.force[a][m].get();
  }
  stress_results_[block] = kernels_.evaluate_stress_points(work);
}

template <class T, int D>
void Step<T, D>::move(int block) {
  const auto [body, local] = owner(block);
  const Block<D>& range = body.layout.blocks()[local];
  kernels::Motion<T, D> work = {};
  work.segments = body.layout.segments_of(range);
  work.segment_count = range.segment_count;
  const double half = state_.clock.damping * time_step_ / 2;
  work.kept = static_cast<T>((1 - half) / (1 + half));
  work.gained = static_cast<T>(time_step_ / ((1 + half) * state_.clock.mass_scaling));
  work.time_step = static_cast<T>(time_step_);
  work.inverse_mass = body.inverse_mass.get();
  for (int a = 0; a < D; ++a) {
    for (int m = 0; m < kernels::cell_modes<D>; ++m) work.force[a][m] = body.force[a][m].get();
    work.traction[a] = body.traction[a].get();
    work.internal[a] = body.internal[a].get();
    work.velocity[a] = body.velocity[a].get();
    work.displacement[a] = body.displacement[a].get();
  }
  motion_results_[block] = kernels_.advance_motion(work);
  hold(body, local);
}

// Takes back what a held particle moved against its walls; in the order of the walls, so that the
// last has the last word.
template <class T, int D>
void Step<T, D>::hold(Body<T, D>& body, int local) {
  for (const ConstrainedParticle<D>& held : body.held[local]) {
    Point<D> excess;
    double along = 0, slips = 0;
    for (int a = 0; a < D; ++a) {
      excess[a] = body.velocity[a][held.slot] - wall_velocity_[held.wall][a];
      along += excess[a] * held.normal[a];
      slips += held.normal[a] * held.normal[a];
    }
    for (int a = 0; a < D; ++a) {
      const double undone = slips > 0 ? along * held.normal[a] : excess[a];
      body.velocity[a][held.slot] -= undone;
      body.displacement[a][held.slot] -= time_step_ * undone;
    }
  }
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::total_lagrangian
