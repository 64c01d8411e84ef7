#include "engine/simulation/run.hpp"

#include <fmt/format.h>
#include <pliant/version.hpp>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "engine/case/checks/stability.hpp"
#include "engine/case/method_rules.hpp"
#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/case/writing/resolved.hpp"
#include "engine/output/archive/checkpoint.hpp"
#include "engine/output/interrupt.hpp"
#include "engine/output/progress.hpp"
#include "engine/output/results/result_file.hpp"
#include "engine/output/summary.hpp"
#include "engine/simulation/default_samples.hpp"
#include "engine/simulation/histories.hpp"
#include "engine/simulation/lost_stiffness.hpp"
#include "engine/simulation/passing_bodies.hpp"
#include "engine/simulation/run_identity.hpp"
#include "engine/simulation/run_summary.hpp"
#include "engine/simulation/schedule.hpp"
#include "engine/simulation/watch.hpp"

namespace pliant {

namespace {

using Clock = std::chrono::steady_clock;

class Run {
 public:
  Run(const Case& settings, const RunOptions& options, const MethodRegistry& methods)
      : settings_(settings),
        options_(options),
        solver_(methods.make(settings, {options.threads, options.isa})),
        histories_(settings_),
        watch_(settings),
        frames_(settings.output.every),
        samples_(settings.output.measure_every),
        checkpoints_(settings.output.checkpoint_every),
        default_samples_(settings),
        progress_(options.quiet) {}

  RunEnd operator()() {
    const auto start = Clock::now();
    const Interrupt interrupt;
    options_.when_set_up();
    options_.resume ? resume() : begin();
    show();
    while (!at_end()) {
      step();
      observe();
      warn(watch_.observe(*solver_, at_end()));
      if (interrupt.requested() && !at_end()) {
        save();
        progress_.message(fmt::format("interrupted at t = {:.6g} s; continue with --resume",
                                      solver_->clock().time));
        return RunEnd::interrupted;
      }
    }
    finish(std::chrono::duration<double>(Clock::now() - start).count());
    return RunEnd::done;
  }

 private:
  // The steps of a method that looks ahead do not depend on output times; only the end of the run
  // shortens the last one.
  void step() {
    const double end = settings_.time.end, now = solver_->clock().time;
    if (!solver_->shows_states_within_steps()) {
      solver_->step(std::min({end, frames_.next(), samples_.next(), checkpoints_.next()}) - now);
      return;
    }
    const double after = now + solver_->next_step(end - now);
    for (;;) {
      const double next = std::min(frames_.next(), samples_.next());
      if (next >= after * (1 - 1e-12)) break;
      solver_->look_ahead(next, [this] { put_out(false); });
    }
    solver_->step(end - now);
  }

  bool at_end() const { return solver_->clock().time >= settings_.time.end * (1 - 1e-12); }

  RunDescription describe() const {
    RunDescription description;
    description.case_name = settings_.name;
    description.title = settings_.title;
    description.method = settings_.method;
    description.version = std::string(version);
    description.dimension = settings_.dimension;
    description.resolved_case = resolved_toml(settings_);
    description.identity = identity_of(settings_);
    return description;
  }

  void warn(const std::string& warning) {
    if (!warning.empty()) progress_.message(warning);
  }

  void warn_of_method() {
    for (const std::string& warning : warnings_of_method(settings_)) warn("warning: " + warning);
  }

  void begin() {
    warn_of_method();
    result_.emplace(ResultFile::create(options_.folder, describe()));
    start_ = conserved(solver_->integrals());
    watch_.begin(*solver_);
    particles_at_start_ = solver_->particles();
    sample();
    result_->append(solver_->frame(parts()));
  }

  void resume() {
    const ArchiveReader archive = open_checkpoint(options_.folder);
    require_same_run(archive, settings_);
    solver_->restore(archive);
    histories_.get(archive);
    watch_.get(archive);
    frames_.restore(archive.scalar<std::int64_t>("schedule/frames"));
    samples_.restore(archive.scalar<std::int64_t>("schedule/samples"));
    default_samples_.restore(histories_.last_time());
    checkpoints_.restore(archive.scalar<std::int64_t>("schedule/checkpoints"));
    particles_at_start_ = archive.scalar<std::int64_t>("start/particles");
    const auto start = archive.get<double>("start/conserved");
    start_ = {start[0],
              {start[1], start[2], start[3]},
              {start[4], start[5], start[6]},
              start[7],
              start[8],
              start[9]};
    result_.emplace(ResultFile::resume(options_.folder, describe(), get_extent(archive, "result")));
  }

  void put_out(bool everything) {
    const double t = solver_->clock().time;
    if (samples_.reached(t) || everything) sample();
    if (!frames_.reached(t) && !everything) return;
    result_->append(solver_->frame(parts()));
    has_new_frame_ = true;
  }

  void observe() {
    const double t = solver_->clock().time;
    const bool last = at_end();
    const bool due = solver_->is_measuring_due();
    if (default_samples_.due(*solver_) && !last) sample();
    put_out(last);
    // Without an interval of their own, checkpoints are written with frames. There is none at the
    // end: a run that continues to a later end must not keep what exists only because of this end,
    // namely the last frame and measurements, and a shortened last step.
    const bool save_now =
        checkpoints_.reached(t) || (has_new_frame_ && settings_.output.checkpoint_every == 0);
    has_new_frame_ = false;
    if (save_now && !last) save();
    warn_of_instability();
    warn_of_bodies(due, last);
    show();
  }

  void show() {
    progress_.update({solver_->clock().time, settings_.time.end, solver_->clock().step,
                      solver_->time_step(), solver_->particle_stages()});
  }

  // A given step may be stable at rest and too long for the present state of the material.
  void warn_of_instability() {
    if (is_unstable_) return;
    const std::string warning = stability_warning(settings_, solver_->clock().wave_speed);
    is_unstable_ = !warning.empty();
    if (!is_unstable_ || !stability_warning(settings_).empty()) return;
    progress_.message(fmt::format("warning: t = {:.6g} s: {}", solver_->clock().time, warning));
  }

  // What goes wrong only as bodies deform is searched for now and then, and told once.
  void warn_of_bodies(bool is_measuring_due, bool last) {
    const auto search = [&](bool is_due, std::string (*warning_of)(const Solver&), bool& is_told) {
      if (is_told || !(is_due || last)) return;
      const std::string warning = warning_of(*solver_);
      is_told = !warning.empty();
      warn(warning);
    };
    constexpr std::int64_t for_bodies = 64, for_parts = 2048;  // steps between searches
    const std::int64_t step = solver_->clock().step;
    search(is_measuring_due, lost_stiffness_warning, is_beyond_range_);
    search(true, passing_tool_warning, tool_passes_);
    search(step % for_bodies == 0, passing_bodies_warning, bodies_pass_);
    search(step % for_parts == 0, passing_parts_warning, parts_pass_);
  }

  FrameParts parts() const { return {settings_.output.ghosts, settings_.output.surface}; }

  void sample() {
    histories_.add(solver_->clock().time, solver_->measure());
    for (std::size_t m = 0; m < settings_.measurements.size(); ++m) {
      const MeasurementCase& measurement = settings_.measurements[m];
      result_->append_history(measurement.name, std::string(unit_of(settings_, measurement)),
                              solver_->clock().time, histories_.last(m));
    }
  }

  void save() {
    const ResultExtent extent = result_->flush();
    write_checkpoint(options_.folder, [&](ArchiveWriter& archive) {
      put_identity(archive, settings_);
      solver_->save(archive);
      histories_.put(archive);
      watch_.put(archive);
      archive.put("schedule/frames", frames_.count());
      archive.put("schedule/samples", samples_.count());
      archive.put("schedule/checkpoints", checkpoints_.count());
      archive.put("start/particles", particles_at_start_);
      const std::array<double, 10> start = {start_.mass,
                                            start_.momentum[0],
                                            start_.momentum[1],
                                            start_.momentum[2],
                                            start_.angular_momentum[0],
                                            start_.angular_momentum[1],
                                            start_.angular_momentum[2],
                                            start_.kinetic_energy,
                                            start_.strain_energy,
                                            start_.total_energy};
      archive.put("start/conserved", std::span<const double>(start));
      put_extent(archive, "result", extent);
    });
  }

  void finish(double wall_seconds) {
    result_->close();
    progress_.finish();
    Summary summary = summary_of(settings_, {options_.threads, options_.isa}, *solver_);
    summary.wall_time = wall_seconds;
    summary.particles.start = particles_at_start_;
    summary.conserved.start = start_;
    summary.conserved.end = conserved(solver_->integrals());
    summary.checks = watch_.report();
    for (std::size_t m = 0; m < settings_.measurements.size(); ++m) {
      const MeasurementCase& measurement = settings_.measurements[m];
      summary.measurements.push_back({measurement.name,
                                      std::string(unit_of(settings_, measurement)),
                                      histories_.last(m), histories_.why_missing(m)});
    }
    write_summary(options_.folder, summary);
    progress_.report(report_of(options_.folder, summary));
    warn_of_inertia(summary.conserved.end);
  }

  // Scaled mass is artificial: if its inertia matters, the result is not the static one.
  void warn_of_inertia(const ConservedQuantities& end) {
    const StepLimits limits = step_limits(settings_);
    constexpr double small = 0.01;
    if (!limits.mass_follows_step && limits.mass_scaling == 1) return;
    if (!(end.kinetic_energy > small * end.strain_energy)) return;
    progress_.message(fmt::format(
        "warning: the kinetic energy of the scaled mass is {:.2g} of the strain energy in the end: "
        "not the static solution; load more slowly (time.end), scale the mass less, or add "
        "discretisation.damping",
        end.kinetic_energy / end.strain_energy));
  }

  const Case& settings_;
  const RunOptions& options_;
  std::unique_ptr<Solver> solver_;
  Histories histories_;
  Watch watch_;
  Schedule frames_, samples_, checkpoints_;
  DefaultSamples default_samples_;
  Progress progress_;
  std::optional<ResultFile> result_;
  ConservedQuantities start_;
  std::int64_t particles_at_start_ = 0;
  bool has_new_frame_ = false;    ///< since the last checkpoint was considered
  bool is_unstable_ = false;      ///< the step is above the stability limit
  bool tool_passes_ = false;      ///< through the surface of a body
  bool bodies_pass_ = false;      ///< through each other
  bool parts_pass_ = false;       ///< of a body through each other
  bool is_beyond_range_ = false;  ///< a linear material has lost its stiffness
};

}  // namespace

RunEnd run_case(const Case& settings, const RunOptions& options, const MethodRegistry& methods) {
  return Run(settings, options, methods)();
}

}  // namespace pliant
