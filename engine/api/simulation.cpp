#include <pliant/error.hpp>
#include <pliant/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/api/find.hpp"
#include "engine/api/session.hpp"
#include "engine/api/translated.hpp"
#include "engine/case/reading/read_case.hpp"
#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/case/writing/resolved.hpp"
#include "engine/method/registry.hpp"
#include "engine/output/archive/archive.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant {

struct Simulation::State {
  std::unique_ptr<Solver> solver;
  std::optional<Session> session;
  std::vector<std::string> bodies;
  std::vector<double> start;   ///< [measurement] value at t = 0, for relative measurements
  std::vector<double> latest;  ///< [measurement] impulse at the last query, for forces
  std::vector<double> latest_time;

  const Case& settings() const { return solver->settings(); }
};

Simulation::Simulation(const CaseFile& case_file, const SimulationOptions& options)
    : state_(std::make_unique<State>()) {
  translated([&] {
    const Case settings =
        parse_case(case_file.text(), case_file.file(), case_file.settings(), methods().rules());
    state_->solver = methods().make(settings, solver_options(options.threads, options.isa));
    state_->session.emplace(*state_->solver);
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
  translated([&] { state_->session->step(); });
}

void Simulation::advance(double until) { advance(until, HUGE_VAL); }

Progress Simulation::advance(double until, double budget) {
  return translated([&] { return state_->session->advance(until, budget); });
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
  enter({.kind = Input::Kind::pressure,
         .time = time(),
         .name = std::string(boundary),
         .value = pressure});
}

void Simulation::set_wall_velocity(std::string_view boundary,
                                   const std::array<double, 3>& velocity) {
  enter({.kind = Input::Kind::wall_velocity,
         .time = time(),
         .name = std::string(boundary),
         .first = velocity});
}

void Simulation::move_blade(std::string_view cut, const std::array<double, 3>& from,
                            const std::array<double, 3>& to) {
  enter({.kind = Input::Kind::blade,
         .time = time(),
         .name = std::string(cut),
         .first = from,
         .second = to});
}

void Simulation::lift_blade(std::string_view cut) {
  enter({.kind = Input::Kind::lift, .time = time(), .name = std::string(cut)});
}

std::array<double, 3> Simulation::blade_force(std::string_view cut) const {
  std::array<double, 3> force;
  translated([&] {
    const Solver& solver = *state_->solver;
    force = blades_of(*state_->solver).blade_force(find(solver.settings().cuts, cut, "cut"));
  });
  return force;
}

void Simulation::enter(const Input& input) {
  translated([&] { state_->session->enter(input); });
}

void Simulation::play(const std::vector<Input>& session) {
  translated([&] { state_->session->play(session); });
}

const std::vector<Input>& Simulation::session() const { return state_->session->record(); }

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
  state_->session->forget();
  std::ranges::fill(state_->latest_time, time());
}

}  // namespace pliant
