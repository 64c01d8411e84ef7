#include "engine/accuracy/climb.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <cmath>
#include <cstdio>

#include "engine/accuracy/rung_run.hpp"
#include "engine/bench/machine.hpp"
#include "engine/output/interrupt.hpp"

namespace pliant::accuracy {

namespace {

class Climb {
 public:
  Climb(const Ladders& ladders, const ClimbOptions& options)
      : ladders_(ladders), options_(options) {
    record_.machine = bench::machine_description();
    record_.threads = options.threads;
    for (const Problem& problem : ladders.problems) {
      for (const Series& series : problem.series) {
        record_.rows.push_back({problem.name, series.name, {}});
        for (const Rung& rung : series.rungs) record_.rows.back().rungs.push_back({rung});
      }
    }
  }

  AccuracyRecord operator()() {
    for (int repetition = 1; repetition <= options_.repetitions; ++repetition) {
      auto row = record_.rows.begin();
      for (const Problem& problem : ladders_.problems) {
        for (const Series& series : problem.series) climb(problem, series, *row++, repetition);
      }
    }
    record_.interrupted = interrupt_.requested();
    return record_;
  }

 private:
  void climb(const Problem& problem, const Series& series, SeriesRecord& row, int repetition) {
    const std::filesystem::path folder =
        options_.folder / fmt::format("{}", repetition) / problem.name / series.name;
    std::filesystem::create_directories(folder);
    bool is_too_slow = false;
    for (std::size_t r = 0; r < series.rungs.size() && !interrupt_.requested(); ++r) {
      RungRecord& rung = row.rungs[r];
      if (is_too_slow) {
        rung.error = std::nan("");
        rung.message = "not run: a coarser run took too long";
        continue;
      }
      const RungRun run{folder / fmt::format("{}", r), command_of(problem, series, rung)};
      batch::Outcome outcome = outcome_of(run);
      if (interrupt_.requested()) return;
      if (outcome.exit_status == 2) {
        throw InputError(fmt::format("{}: {}", row.name(), outcome.message));
      }
      add(rung, outcome, problem.targets);
      is_too_slow = outcome.exit_status != 0 && ladders_.time_limit > 0 &&
                    outcome.wall_seconds > ladders_.time_limit;
      show(row, rung, repetition);
    }
  }

  std::vector<std::string> command_of(const Problem& problem, const Series& series,
                                      const RungRecord& rung) const {
    std::vector<std::string> command = {options_.program.string(),
                                        "run",
                                        problem.case_file.string(),
                                        "--quiet",
                                        "--threads",
                                        fmt::format("{}", options_.threads)};
    for (const auto* settings : {&problem.settings, &series.settings, &rung.settings}) {
      for (const std::string& setting : *settings) {
        command.insert(command.end(), {"--set", setting});
      }
    }
    return command;
  }

  batch::Outcome outcome_of(const RungRun& run) {
    if (const auto before = kept(run)) return *before;
    // A run that continues from a checkpoint would seem to take less time.
    std::filesystem::remove_all(run.folder);
    batch::Job job({}, run.folder, run.command);
    batch::Outcome outcome = end_of(job, ladders_.time_limit, end_of_child_, interrupt_);
    if (outcome.exit_status == 0) keep(run, outcome);
    return outcome;
  }

  void show(const SeriesRecord& row, const RungRecord& rung, int repetition) const {
    const std::string found =
        std::isnan(rung.error) ? rung.message
                               : fmt::format("{} particles, {:.2f} s, error {:.3g} %",
                                             rung.particles, rung.seconds.back(), 100 * rung.error);
    fmt::print(stderr, "{}/{} {} {}: {}\n", repetition, options_.repetitions, row.name(),
               fmt::join(rung.settings, " "), found);
  }

  const Ladders& ladders_;
  const ClimbOptions& options_;
  const batch::EndOfChild end_of_child_;
  const Interrupt interrupt_;
  AccuracyRecord record_;
};

}  // namespace

AccuracyRecord climb(const Ladders& ladders, const ClimbOptions& options) {
  if (!options.resume && std::filesystem::exists(options.folder / "1")) {
    throw InputError(
        fmt::format("{}: holds runs of ladders; continue them with --resume, or give "
                    "another --out",
                    options.folder.string()));
  }
  return Climb(ladders, options)();
}

}  // namespace pliant::accuracy
