#include "engine/simulation/run_summary.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <tbb/version.h>
#include <pliant/version.hpp>
#include <xsimd/xsimd.hpp>

#include <ctime>

#include "engine/case/vocabulary/words.hpp"

namespace pliant {

namespace {

std::int64_t peak_memory() {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{1024} * usage.ru_maxrss;
}

auto versions() {
  return decltype(Summary::versions){
      {"pliant", std::string(version)},
      {"oneTBB", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
      {"xsimd",
       fmt::format("{}.{}.{}", XSIMD_VERSION_MAJOR, XSIMD_VERSION_MINOR, XSIMD_VERSION_PATCH)},
      {"HDF5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE)}};
}

}  // namespace

Summary summary_of(const Case& settings, const SolverOptions& options, const Solver& solver) {
  Summary summary;
  summary.case_name = settings.name;
  summary.versions = versions();
  summary.method = settings.method;
  summary.precision = words<Precision>[static_cast<int>(settings.precision)].text;
  summary.particles.end = solver.particles();
  summary.particles.ghosts = solver.ghosts();
  summary.steps = solver.clock().step;
  summary.physical_time = solver.clock().time;
  summary.processor_time = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  summary.peak_memory = peak_memory();
  for (const auto& timer : solver.step_totals().timers()) {
    summary.phases.push_back({timer.name, timer.seconds});
  }
  summary.performance.particle_stages = solver.particle_stages();
  summary.performance.step_wall_time = solver.step_seconds();
  summary.performance.particle_stages_per_second =
      solver.step_seconds() > 0
          ? static_cast<double>(solver.particle_stages()) / solver.step_seconds()
          : 0;
  summary.performance.threads = options.threads;
  summary.performance.isa = std::string(kernels::name(options.isa));
  return summary;
}

}  // namespace pliant
