#pragma once

#include <cstddef>
#include <vector>

#include "scheduler/step_graph.hpp"

namespace pliant::profile {

/// Time that the workers spent outside phases, summed over them [s].
struct IdleTime {
  double waiting = 0;     ///< until a node was ready: for other workers
  double scheduling = 0;  ///< from then until the node ran, and around the graph
};

/// Splits the idle time of graphs. A worker waits until all predecessors of the node that it runs
/// next have ended, or the whole graph when it runs none; the rest is scheduling.
class IdleTimeSplitter {
 public:
  /// Keeps the last run of the graph, in time proportional to its edges.
  void add(const scheduler::StepGraph& graph);

  /// Idle time of all runs that were added since the last call.
  IdleTime take();

 private:
  struct Work {
    int worker;
    double ready, start, stop;  // since the graph began [s]
  };
  struct Run {
    std::size_t nodes;
    double wall_seconds;
    int workers;
  };

  static IdleTime split(const Run& run, const Work* works);

  std::vector<double> ready_;  // [node] when its last predecessor had ended [s]
  std::vector<Work> works_;    // of all runs
  std::vector<Run> runs_;
};

}  // namespace pliant::profile
