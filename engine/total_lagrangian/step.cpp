#include "engine/total_lagrangian/step.hpp"

#include <algorithm>

#include "engine/method/phase_rows.hpp"

// A step of the total Lagrangian method. Everything happens on the lattice of the undeformed body,
// where particles always have the same neighbours.
//
//     pressure          the force on the surface inside each cell where a load acts (TL.7)
//     traction          the force of gravity on each particle, and its share in the former
//     stress            F at each stress point from the particles at its cell's corners, the
//                       stress, and its force on those corners (TL.2)-(TL.6)
//     motion            the force on each particle (TL.5); velocity and displacement by central
//                       differences with damping (TL.8); the velocity that walls set
//
// There is one evaluation of the stress in each step, and the state is displacement and velocity
// alone: F is a function of where the particles are, so that nothing creeps under a constant load.
namespace pliant::total_lagrangian {

using scheduler::Phase;
using enum Group;

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::TotalLagrangianTable<T, D>& kernels)
    : state_(state),
      settings_(settings),
      kernels_(kernels),
      boundary_forces_(state, settings),
      contact_(state, settings) {}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  stress_results_.assign(state_.blocks.size(), {0, -1});
  motion_results_.assign(state_.blocks.size(), {});
  boundary_forces_.prepare_blocks();
  prepare_contact();
  relaxation_.resize(state_.bodies.size());
  memory_.resize(state_.bodies.size());
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    relaxation_[b].resize(state_.bodies[b].prony.size());
    memory_[b].clear();
    for (Buffer<T>& pressure : state_.bodies[b].memory_pressure) {
      memory_[b].push_back(pressure.get());
    }
  }
  const auto run = [this](auto function) {
    return [this, function](int block) { (this->*function)(block); };
  };
  std::vector<Phase> phases;
  PhaseRows rows(phases);
  if (!state_.boundaries.pressures.empty()) {
    rows.each("pressure", near(of(displacement)) + own(of(surface)), own(of(patch_forces)),
              [this](int block) { boundary_forces_.sum_patch_loads(block); });
  }
  if (boundary_forces_.act_on_particles()) {
    rows.each("traction",
              near(of(patch_forces)) + own(of(surface) + of(constants) + of(displacement)),
              own(of(tractions)), [this](int block) { boundary_forces_.distribute(block); });
  }
  rows.each("stress", near(of(displacement)) + own(of(constants) + of(memory)),
            own(of(corner_forces) + of(memory) + of(results)), run(&Step::evaluate_stress));
  rows.each("motion",
            near(of(corner_forces) + of(patch_forces)) +
                own(of(tractions) + of(constants) + of(surface) + of(internal_forces) +
                    of(velocity) + of(displacement)),
            own(of(internal_forces) + of(velocity) + of(displacement) + of(results)),
            run(&Step::move));
  return phases;
}

template <class T, int D>
void Step<T, D>::prepare_contact() {
  contact_.clear_surfaces();
  if (!contact_.exists()) return;
  for (Body<T, D>& body : state_.bodies) {
    std::vector<Vertex<D>> corners;
    corners.reserve(D * body.facets.size());
    for (const Facet<D>& facet : body.facets) {
      corners.insert(corners.end(), facet.vertex.begin(), facet.vertex.end());
    }
    contact_.add_surface(body, corners);
  }
}

template <class T, int D>
void Step<T, D>::prepare(const Advance& advance) {
  advance_ = advance;
  boundary_forces_.prepare(advance.time, advance.kick(), advance.length);
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    const Body<T, D>& body = state_.bodies[b];
    for (std::size_t i = 0; i < body.prony.size(); ++i) {
      const kernels::PronyTerm<T> term = {static_cast<T>(body.prony[i].ratio),
                                          static_cast<T>(body.prony[i].time)};
      relaxation_[b][i] =
          kernels::relaxation<T>(term, body.material.bulk_modulus, advance.previous);
    }
  }
}

template <class T, int D>
StepResult Step<T, D>::fold() {
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
  if (stiffness > 0 && inertia > 0) result.rayleigh = stiffness / inertia;
  boundary_forces_.fold(inertia);
  contact_.apply(advance_.time, advance_.kick(), advance_.length, advance_.length);
  return result;
}

template <class T, int D>
kernels::CellViscosity<T> Step<T, D>::viscosity(int block) const {
  const int b = state_.blocks[block].body;
  Body<T, D>& body = state_.bodies[b];
  return {static_cast<int>(body.prony.size()), relaxation_[b].data(), memory_[b].data(),
          body.volume_change.get()};
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
  work.examine = advance_.examine;
  work.material = body.material;
  work.viscosity = viscosity(block);
  work.fitted = body.fitted.data() + body.first_fitted[local];
  work.fitted_count = body.first_fitted[local + 1] - body.first_fitted[local];
  work.fraction = body.regular_fraction.get();
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
  const double half = state_.clock.damping * advance_.kick() / 2;
  work.kept = static_cast<T>((1 - half) / (1 + half));
  work.gained = static_cast<T>(advance_.kick() / ((1 + half) * state_.clock.mass_scaling));
  work.time_step = static_cast<T>(advance_.length);
  work.inverse_mass = body.inverse_mass.get();
  for (int a = 0; a < D; ++a) {
    for (int m = 0; m < kernels::cell_modes<D>; ++m) work.force[a][m] = body.force[a][m].get();
    work.traction[a] = body.traction[a].get();
    work.internal[a] = body.internal[a].get();
    work.velocity[a] = body.velocity[a].get();
    work.displacement[a] = body.displacement[a].get();
  }
  boundary_forces_.begin_motion(block);
  motion_results_[block] = kernels_.advance_motion(work);
  boundary_forces_.end_motion(block);
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::total_lagrangian
