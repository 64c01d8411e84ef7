#include "engine/sph/solver.hpp"

#include "engine/method/step_length.hpp"
#include "engine/remeshed/observe/field_views.hpp"
#include "engine/remeshed/observe/frame.hpp"
#include "engine/remeshed/observe/measure.hpp"
#include "engine/remeshed/setup/setup.hpp"
#include "engine/remeshed/state/check_state.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "engine/remeshed/state/state_archive.hpp"

namespace pliant::sph {

namespace {

std::vector<std::string> remedies(const Case& settings) {
  return {smaller_step(settings), "raise the artificial viscosity (sph.artificial_viscosity)",
          "use a finer spacing"};
}

}  // namespace

// Neighbours are those within the support of the kernel (RP.14).
template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : pliant::Solver(a_case, options),
      kernels_(kernels::RemeshedTable<T, D>::of(options.isa)),
      state_(remeshed::make_state<T, D>(settings())),
      step_(state_, settings(), kernels_),
      remeshings_(settings(), state_, kernels_, workers(), remeshed::Outside::vacant),
      search_(state_, kernels::Kernel::quartic_spline, true),
      step_graph_(remeshed::resource::names()),
      search_graph_(remeshed::resource::names()) {
  remeshings_.place_initial();
  number_slots();
  remeshed::check_bodies(settings(), state_, remedies);
  scheduler::StepGraph initial_stress(step_.stress_phases(),
                                      connect_blocks<D>(remeshings_.layouts(), 0),
                                      remeshed::resource::names());
  run(initial_stress);
  step_.fold();
  remeshed::check_finite(settings(), step_.results(), state_, remedies);
  state_.clock.wave_speed = step_.results().total().wave_speed;
}

template <class T, int D>
void Solver<T, D>::number_slots() {
  number_blocks<D>(remeshings_.layouts(), state_.blocks);
  search_.clear();
  step_.use_slots();
  present_graph_ = &step_graph_.over(remeshings_.layouts(), [&] { return step_.phases(); });
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  return asked_step(settings(), state_.clock.wave_speed);
}

template <class T, int D>
void Solver<T, D>::take_step(double dt) {
  move(dt);
  add_particle_stages(4 * particles());
}

template <class T, int D>
void Solver<T, D>::look_ahead(double time, const std::function<void()>& look) {
  before_look_.keep(state_);
  move(time - state_.clock.time);
  look();
  before_look_.put_back(state_);
}

template <class T, int D>
void Solver<T, D>::move(double dt) {
  step_.prepare(dt);
  if (search_.is_due(dt)) {
    run(search_graph_.over(remeshings_.layouts(), [&] { return search_.phases(); }));
  }
  run(*present_graph_);
  step_.fold();
  remeshed::check_finite(settings(), step_.results(), state_, remedies);
  remeshed::check_strain(settings(), step_.results(), state_, dt, remedies);
  remeshed::Clock& clock = state_.clock;
  clock.time += dt;
  ++clock.step;
  clock.wave_speed = step_.results().total().wave_speed;
  search_.add_strain(step_.results(), dt);
}

template <class T, int D>
std::vector<double> Solver<T, D>::measure_each(std::span<const MeasurementCase> measurements) {
  return remeshed::Measurer<T, D>(settings(), state_, workers(), {})(measurements);
}

template <class T, int D>
BodyIntegrals Solver<T, D>::integrals() {
  return remeshed::Measurer<T, D>(settings(), state_, workers(), {}).totals();
}

template <class T, int D>
Frame Solver<T, D>::frame(const FrameParts& parts) {
  return remeshed::take_frame<T, D>(state_, kernels_, {}, {}, parts);
}

template <class T, int D>
std::vector<SlotRun> Solver<T, D>::particle_runs(int body) const {
  return remeshed::slot_runs(state_.bodies.at(body));
}

template <class T, int D>
std::vector<FieldView> Solver<T, D>::fields(int body) const {
  return remeshed::field_views(state_.bodies.at(body));
}

template <class T, int D>
std::vector<std::array<double, 3>> Solver<T, D>::positions(int body) const {
  return remeshed::present_positions(state_.bodies.at(body));
}

template <class T, int D>
void Solver<T, D>::save_state(ArchiveWriter& archive) const {
  remeshed::put_state(archive, state_);
}

template <class T, int D>
void Solver<T, D>::restore_state(const ArchiveReader& archive) {
  remeshed::get_state(archive, state_, remeshings_);
  number_slots();
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::sph
