#include <pliant/error.hpp>
#include <pliant/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "engine/case/measurement_kinds.hpp"
#include "engine/case/problems.hpp"
#include "engine/case/read_case.hpp"
#include "engine/case/resolved.hpp"
#include "engine/method/registry.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/output/archive.hpp"
#include "engine/output/error.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant {

namespace {

/// Calls `f` and gives its exceptions the public types.
template <class F>
auto translated(F&& f) {
  try {
    return f();
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  } catch (const StepFailure& error) {
    throw RunError(error.what());
  } catch (const OutputError& error) {
    throw RunError(error.what());
  } catch (const std::bad_alloc&) {
    throw RunError("out of memory; use a coarser spacing (discretisation.spacing)");
  }
}

/// The position of the element called `name` in a list of the case.
template <class List>
std::size_t find(const List& list, std::string_view name, std::string_view what) {
  const auto found =
      std::ranges::find(list, name, [](const auto& element) { return element.name; });
  if (found != list.end()) return found - list.begin();
  std::vector<std::string_view> known;
  known.reserve(list.size());
  for (const auto& element : list) known.push_back(element.name);
  throw InputError(fmt::format("the case has no {} `{}`; {}", what, name,
                               known.empty() ? "it has none" : suggestion(name, known, "it has")));
}

}  // namespace

struct Simulation::State {
  std::unique_ptr<Solver> solver;
  std::vector<std::string> bodies;
  std::vector<double> start;   ///< [measurement] value at t = 0 of those that are relative to it
  std::vector<double> latest;  ///< [measurement] impulse of forces when they were last asked for
  std::vector<double> latest_time;

  const Case& settings() const { return solver->settings(); }
};

Simulation::Simulation(const CaseFile& case_file, const SimulationOptions& options)
    : state_(std::make_unique<State>()) {
  translated([&] {
    const Case settings =
        parse_case(case_file.text(), case_file.file(), case_file.settings(), methods().rules());
    state_->solver = methods().make(settings, solver_options(options.threads, options.isa));
  });
  for (const BodyCase& body : state_->settings().bodies) state_->bodies.push_back(body.name);
  const std::size_t count = state_->settings().measurements.size();
  state_->start.assign(count, 1);
  state_->latest.assign(count, 0);
  state_->latest_time.assign(count, time());
  for (std::size_t m = 0; m < count; ++m) {
    if (state_->settings().measurements[m].relative) state_->start[m] = state_->solver->measure(m);
  }
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::step() {
  translated([&] { state_->solver->step(HUGE_VAL); });
}

void Simulation::advance(double until) {
  translated([&] { state_->solver->advance(until); });
}

double Simulation::time() const { return state_->solver->clock().time; }
double Simulation::time_step() const { return state_->solver->time_step(); }
std::int64_t Simulation::step_count() const { return state_->solver->clock().step; }
int Simulation::dimension() const { return state_->settings().dimension; }
const std::vector<std::string>& Simulation::bodies() const { return state_->bodies; }
std::int64_t Simulation::particle_count() const { return state_->solver->particles(); }

Totals Simulation::totals() {
  const BodyIntegrals sum = translated([&] { return state_->solver->integrals(); });
  return {sum.mass, sum.momentum, sum.angular_momentum, sum.kinetic_energy, sum.strain_energy};
}

std::vector<SlotRun> Simulation::particles(int body) const {
  return state_->solver->particle_runs(checked(body));
}

std::vector<FieldView> Simulation::fields(int body) const {
  return state_->solver->fields(checked(body));
}

FieldView Simulation::field(int body, std::string_view name) const {
  const std::vector<FieldView> all = fields(body);
  return all[find(all, name, "field")];
}

std::vector<std::array<double, 3>> Simulation::positions(int body) const {
  return state_->solver->positions(checked(body));
}

int Simulation::checked(int body) const {
  if (body >= 0 && body < static_cast<int>(state_->bodies.size())) return body;
  throw InputError(
      fmt::format("body {}: bodies are numbered from 0 to {}", body, state_->bodies.size() - 1));
}

double Simulation::measurement(std::string_view name) {
  const std::size_t m = find(state_->settings().measurements, name, "measurement");
  const MeasurementCase& measurement = state_->settings().measurements[m];
  if (measurement.reads_history()) {
    throw InputError(fmt::format(
        "measurement `{}` reads the history of another one; keep samples of that and evaluate them",
        name));
  }
  const double value = translated([&] { return state_->solver->measure(m); });
  if (row_of(measurement.kind).sampling != Sampling::rate) return value / state_->start[m];
  const double impulse = value - state_->latest[m], passed = time() - state_->latest_time[m];
  state_->latest[m] = value;
  state_->latest_time[m] = time();
  return passed > 0 ? impulse / passed : 0;
}

void Simulation::set_pressure(std::string_view boundary, double pressure) {
  const std::size_t b = find(state_->settings().boundaries, boundary, "boundary");
  translated([&] { state_->solver->loads().set_pressure(b, pressure); });
}

void Simulation::set_wall_velocity(std::string_view boundary,
                                   const std::array<double, 3>& velocity) {
  const std::size_t b = find(state_->settings().boundaries, boundary, "boundary");
  translated([&] { state_->solver->loads().set_wall_velocity(b, velocity); });
}

void Simulation::save(const std::filesystem::path& file) const {
  translated([&] {
    ArchiveWriter archive(file);
    archive.put("case", resolved_toml(state_->settings()));
    state_->solver->save(archive);
    archive.commit();
  });
}

void Simulation::restore(const std::filesystem::path& file) {
  translated([&] {
    const ArchiveReader archive(file);
    if (archive.text("case") != resolved_toml(state_->settings())) {
      throw InputError(
          fmt::format("{}: this is a state of another case; restore it into a "
                      "simulation that was made from the same case",
                      file.string()));
    }
    state_->solver->restore(archive);
  });
  std::ranges::fill(state_->latest_time, time());
}

}  // namespace pliant
