#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/output/atomic_file.hpp"
#include "scheduler/step_graph.hpp"

namespace pliant::profile {

/// Writes the nodes of each thread, the steps and the frames as a Chrome trace, JSON for Perfetto.
/// Only the longest nodes of each step are written, so that 1000 steps stay below 100 MB.
class TraceWriter {
 public:
  using Clock = std::chrono::steady_clock;

  /// Largest number of nodes of a step; each takes about 100 bytes.
  static constexpr std::size_t most_nodes = 800;

  /// Throws OutputError, like the functions below, when the file cannot be written.
  TraceWriter(const std::filesystem::path& path, int threads);

  /// Records the nodes of the last run of a graph for the present step.
  void add(const scheduler::StepGraph& graph);
  void end_step(Clock::time_point start, double seconds, double simulated_time);
  /// Writes what was recorded; call it between frames.
  void end_frame(Clock::time_point start, double seconds, double simulated_time);
  /// Gives the file its name.
  void publish();

 private:
  struct Event {
    double start, seconds;  ///< since the start of the trace
    int worker;
    int label;
    int block;
  };
  struct Step {
    double start, seconds, simulated_time;
    std::size_t nodes, left_out;
  };

  double since_start(Clock::time_point time) const;
  int label_of(const scheduler::Phase& phase);
  void write(std::string_view text);

  std::filesystem::path path_;
  TemporaryFile file_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  Clock::time_point start_ = Clock::now();
  std::unordered_map<std::string, int> label_numbers_;
  std::vector<std::string> labels_;
  std::vector<int> label_of_phase_;  // for the present graph
  std::vector<Event> events_;        // in the present frame
  std::vector<Step> steps_;          // in the present frame
  std::size_t first_event_ = 0;      // in the present step
};

}  // namespace pliant::profile
