#pragma once

#include <cstddef>
#include <vector>

#include "scheduler/step_graph.hpp"

namespace pliant::profile {

/// Time of the workers outside phases, summed over the workers [s].
struct IdleTime {
  double waiting = 0;     ///< until a node was ready, because of other workers
  double scheduling = 0;  ///< from then until the node ran, and before and after the graph
};

/// Splits the idle time of graphs. A worker waits until all predecessors of its next node have
/// ended, or for the whole graph if it runs no more nodes. The rest is scheduling.
class IdleTimeSplitter {
 public:
  /// Records the last run of the graph, in time proportional to its edges.
  void add(const scheduler::StepGraph& graph);

  /// Idle time of all runs added since the last call.
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

  std::vector<double> ready_;  // [node] end of its last predecessor [s]
  std::vector<Work> works_;    // of all runs
  std::vector<Run> runs_;
};

}  // namespace pliant::profile
