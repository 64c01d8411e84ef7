#include "engine/point_based/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/checks/stability.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/point_based/bonds/node_frequency.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "engine/point_based/setup.hpp"
#include "engine/undeformed/slip_walls.hpp"

namespace pliant::point_based {

namespace {

constexpr double least_frequency2_over =
    0.8;  // relative to the present one, before the step grows again

template <int D>
void put_blades(ArchiveWriter& archive, const std::vector<BladeLoad<D>>& blades) {
  std::vector<double> values;
  for (const BladeLoad<D>& blade : blades) {
    values.insert(values.end(), blade.impulse.begin(), blade.impulse.end());
    values.insert(values.end(), blade.force.begin(), blade.force.end());
    values.insert(values.end(), {blade.work, blade.power});
  }
  archive.put("blades", std::span<const double>(values));
}

template <int D>
void get_blades(const ArchiveReader& archive, std::vector<BladeLoad<D>>& blades) {
  const auto values = archive.get<double>("blades");
  for (std::size_t b = 0; b < blades.size(); ++b) {
    const std::size_t first = b * (2 * D + 2);
    for (int a = 0; a < D; ++a) {
      blades[b].impulse[a] = values.at(first + a);
      blades[b].force[a] = values.at(first + D + a);
    }
    blades[b].work = values.at(first + 2 * D);
    blades[b].power = values.at(first + 2 * D + 1);
  }
}

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : Base(undeformed::ended_at_slip_walls(a_case, has_elements), options) {
  State<T, D>& state = this->state();
  state.blades.resize(this->settings().cuts.size());
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    Body<T, D>& body = state.bodies[b];
    const BodyCase& source = this->settings().bodies[b];
    BondChoice<D> choice = make_body(this->settings(), source,
                                     place_nodes<D>(this->settings(), source, state.boundaries),
                                     state.boundaries, this->workers(), body);
    state.cuts.push_back(body.has_cuts()
                             ? std::make_unique<BodyCuts<T, D>>(
                                   this->settings(), static_cast<int>(b), std::move(choice), body)
                             : nullptr);
    body.for_each_node([&](std::int64_t slot) {
      state.frequency2 =
          std::max<double>(state.frequency2, energies_of_node * double{body.frequency2[slot]});
    });
    const double slack = kernels::wave_speed_at_rest(source.material);
    const double taut =
        wave_speed_under<D>(source, body.initial_stress, body.is_prestressed() ? body.slots : 0);
    state.clock.wave_speed = std::max(state.clock.wave_speed, taut);
    stiffening_ = std::max(stiffening_, taut * taut / (slack * slack));
  }
  state.clock.damping = parameters_of(this->settings()).damping.value_or(0);
  const scheduler::Blocks blocks = number_blocks(state);
  this->set_step(std::make_unique<Step<T, D>>(state, this->settings(),
                                              kernels::PointBasedTable<T, D>::of(options.isa)),
                 blocks);
}

template <class T, int D>
double Solver<T, D>::automatic_step() const {
  const double viscous = parameters_of(this->settings()).stiffness_damping;
  const double frequency2 = stiffening_ * this->state().frequency2;
  const double longest = std::sqrt(viscous * viscous + 4 / frequency2) - viscous;
  return cfl_number(this->settings()) * longest;
}

// A step whose length always changes would excite vibrations: it shrinks when necessary and grows
// rarely.
template <class T, int D>
void Solver<T, D>::adapt(const Advance&, const StepResult& result) {
  if (result.frequency2 == 0) return;
  double& present = this->state().frequency2;
  const double found = energies_of_node * result.frequency2;
  if (found > present || found < least_frequency2_over * present) present = found;
}

template <class T, int D>
StepFailure Solver<T, D>::failure(const StepResult& result) const {
  const Body<T, D>& body = this->state().bodies[this->state().blocks[result.failed_block].body];
  std::vector<std::string> remedies;
  for (const CutCase& cut : this->settings().cuts) {
    if (cut.puncture_force == 0) continue;
    remedies.push_back(fmt::format(
        "let the blade of cut `{}` enter earlier (a smaller puncture_force)", cut.name));
  }
  remedies.insert(remedies.end(),
                  {smaller_step(this->settings()), "load more slowly",
                   "raise the stabilisation (point_based.stabilisation)", "use a finer spacing"});
  return failed_step(this->settings(), this->clock(),
                     fmt::format("the node of body `{}` that began at {} is no longer finite or "
                                 "has turned inside out",
                                 body.name, coordinates<D>(body.start[result.non_finite])),
                     remedies);
}

template <class T, int D>
void Solver<T, D>::put_blade(std::size_t cut, const std::array<double, 3>& from,
                             const std::array<double, 3>& to) {
  const int owner = this->settings().cuts.at(cut).body;
  this->state().cuts[owner]->put_blade(cut, unpadded<D>(from), unpadded<D>(to),
                                       this->state().bodies[owner]);
}

template <class T, int D>
void Solver<T, D>::lift_blade(std::size_t cut) {
  this->state().cuts[this->settings().cuts.at(cut).body]->lift_blade(cut);
}

template <class T, int D>
std::array<double, 3> Solver<T, D>::blade_force(std::size_t cut) const {
  std::array<double, 3> force = {};
  std::copy_n(this->state().blades.at(cut).force.begin(), D, force.begin());
  return force;
}

template <class T, int D>
void Solver<T, D>::save_state(ArchiveWriter& archive) const {
  Base::save_state(archive);
  archive.put("clock/frequency2", this->state().frequency2);
  put_blades<D>(archive, this->state().blades);
  const State<T, D>& state = this->state();
  for (std::size_t b = 0; b < state.cuts.size(); ++b) {
    if (state.cuts[b]) state.cuts[b]->put(archive, fmt::format("body/{}/cuts", b));
  }
}

template <class T, int D>
void Solver<T, D>::restore_state(const ArchiveReader& archive) {
  Base::restore_state(archive);
  State<T, D>& state = this->state();
  state.frequency2 = archive.scalar<double>("clock/frequency2");
  get_blades<D>(archive, state.blades);
  for (std::size_t b = 0; b < state.cuts.size(); ++b) {
    if (state.cuts[b]) state.cuts[b]->get(archive, fmt::format("body/{}/cuts", b), state.bodies[b]);
  }
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::point_based
