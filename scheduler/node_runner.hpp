#pragma once

namespace pliant::scheduler {

class StepGraph;
struct Node;

/// Runs the nodes of a step instead of the workers, see Workers::delegate; for checks and tools.
class NodeRunner {
 public:
  virtual ~NodeRunner() = default;

  /// Runs one node: calls the function of its phase with its block. Called for one node after
  /// another, in a legal order, without junctions.
  virtual void run(const StepGraph& graph, const Node& node) = 0;
};

}  // namespace pliant::scheduler
