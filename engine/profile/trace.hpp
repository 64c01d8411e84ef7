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

/// Writes the nodes that each thread ran, the steps and the frames as a Chrome trace, JSON that
/// Perfetto opens. Of each step the longest nodes are kept, so that 1000 steps stay below 100 MB.
class TraceWriter {
 public:
  using Clock = std::chrono::steady_clock;

  /// At most this many nodes of a step, of about 100 bytes each.
  static constexpr std::size_t most_nodes = 800;

  /// Throws OutputError, also below, when the file cannot be written.
  TraceWriter(const std::filesystem::path& path, int threads);

  /// Keeps the nodes of the last run of a graph for the present step.
  void add(const scheduler::StepGraph& graph);
  /// Ends the present step.
  void end_step(Clock::time_point start, double seconds, double simulated_time);
  /// Writes what was kept; for between frames.
  void end_frame(Clock::time_point start, double seconds, double simulated_time);
  /// Gives the file its name.
  void publish();

 private:
  struct Event {
    double start, seconds;  ///< since the trace began
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
  std::vector<int> label_of_phase_;  // of the present graph
  std::vector<Event> events_;        // of the present frame
  std::vector<Step> steps_;          // of the present frame
  std::size_t first_event_ = 0;      // of the present step
};

}  // namespace pliant::profile
