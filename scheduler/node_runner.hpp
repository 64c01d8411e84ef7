#pragma once

namespace pliant::scheduler {

class StepGraph;
struct Node;

/// Takes the place of the workers in a step, see Workers::delegate: for checks and tools.
class NodeRunner {
 public:
  virtual ~NodeRunner() = default;

  /// Runs one node: calls the function of its phase with its block. Nodes come one after another,
  /// in a legal order, junctions left out.
  virtual void run(const StepGraph& graph, const Node& node) = 0;
};

}  // namespace pliant::scheduler
