#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

/// Quantities that a run conserves, or should conserve, in SI units.
struct ConservedQuantities {
  double mass = 0;
  std::array<double, 3> momentum = {};
  std::array<double, 3> angular_momentum = {};  ///< about the origin
  double kinetic_energy = 0, strain_energy = 0, total_energy = 0;
};

/// The checks of a run. Shares are relative to the largest energy or work, to the mass at the
/// start, and to the largest momentum or angular momentum. SI units.
struct SummaryChecks {
  struct Largest {
    double share = 0, time = 0;
  };
  bool energy_is_known = false;  ///< whether the method accounts for work
  double wall_work = 0, load_work = 0, body_force_work = 0, cut_work = 0, blade_work = 0;
  double damping = 0;
  double friction = 0;
  double created = 0;  ///< created without work; negative if the method has lost energy
  double largest_energy = 0;
  Largest energy, mass, momentum, angular_momentum;
};

/// A run in one page: the content of summary.json. SI units throughout.
struct Summary {
  struct Phase {
    std::string name;
    double wall_time = 0;  ///< over all threads
  };
  struct Measurement {
    std::string name, unit;
    double value = 0;         ///< at the end
    std::string reason = {};  ///< why there is no value; empty if there is one
  };

  std::string case_name;
  std::vector<std::pair<std::string, std::string>> versions;  ///< program and libraries
  std::string method, precision;
  struct {
    std::int64_t start = 0, end = 0, ghosts = 0;  ///< ghosts: at the end
  } particles;
  std::int64_t steps = 0;
  double physical_time = 0, wall_time = 0;
  double processor_time = 0;     ///< of all threads
  std::int64_t peak_memory = 0;  ///< of the process [B]
  std::vector<Phase> phases;     ///< in the order of the step
  struct {
    double particle_stages_per_second = 0;
    std::int64_t particle_stages = 0;
    double step_wall_time = 0;
    int threads = 1;
    std::string isa;
  } performance;
  struct {
    ConservedQuantities start, end;
  } conserved;
  SummaryChecks checks;
  std::vector<Measurement> measurements;
};

/// JSON with keys in the order above. Numbers read back bitwise; those that are not finite are
/// null.
std::string json_of(const Summary& summary);

/// For users at the end of a run: where the results are, and one line "name  value unit" for each
/// measurement.
std::string report_of(const std::filesystem::path& folder, const Summary& summary);

/// Writes folder/summary.json, complete or not at all. Throws OutputError.
void write_summary(const std::filesystem::path& folder, const Summary& summary);

}  // namespace pliant
