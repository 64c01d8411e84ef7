#pragma once

#include <string>
#include <vector>

#include "engine/bench/calibration.hpp"
#include "engine/bench/steps.hpp"
#include "engine/case/case.hpp"
#include "scheduler/step_record.hpp"

namespace pliant::bench {

/// The measured part of a run.
struct Window {
  std::int64_t steps_before;  ///< not measured
  std::int64_t steps;         ///< at most; the end of the case ends it too
  std::int64_t turn;          ///< steps of a turn (turns.hpp), with the same limit
};

/// A part of a run of a case, and the speed of the machine at that time.
struct Sample {
  std::int64_t particles = 0;        ///< interior, at the end
  std::int64_t particle_stages = 0;  ///< (interior particles) x 4 x steps
  std::int64_t steps = 0, remeshings = 0;
  double bytes_per_particle = 0;     ///< of all fields
  double resident_per_particle = 0;  ///< memory that the process allocated for the solver [B]
  double setup_seconds = 0;          ///< wall time until the solver can step
  Elapsed elapsed;                   ///< of the step loop, including remeshing
  double phase_seconds = 0;          ///< inside phases, of all threads
  double fma_peak = 0;               ///< [flop/s], mean of before and after
  double triad = 0;                  ///< [bytes/s], likewise
  double hand_over = 0;              ///< between two threads and back [s], likewise
  std::vector<scheduler::StepTotals::Timer> phases;

  double rate() const { return static_cast<double>(particle_stages) / elapsed.wall; }
};

Sample measure(const Case& settings, const Window& window, int threads, kernels::Isa isa,
               Triad& triad);

}  // namespace pliant::bench
