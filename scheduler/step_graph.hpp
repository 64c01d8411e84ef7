#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scheduler/blocks.hpp"
#include "scheduler/dependencies.hpp"
#include "scheduler/parallel_gain.hpp"
#include "scheduler/phase.hpp"
#include "scheduler/step_record.hpp"
#include "scheduler/workers.hpp"

namespace pliant::scheduler {

/// Detail of a printed graph: one node for each phase, or for each phase and block.
enum class Detail { phases, blocks };

/// A step as a graph of (phase, block) nodes. Its edges follow from what phases read and write.
///
/// It is built when the set of blocks changes, and run once a step. For any number of workers and
/// any order of execution, each node sees the same values as if the phases ran one after another.
class StepGraph {
 public:
  /// Throws std::invalid_argument as derive_dependencies does.
  StepGraph(std::vector<Phase> phases, Blocks blocks, std::vector<std::string> field_names);
  StepGraph(StepGraph&&) noexcept;
  StepGraph& operator=(StepGraph&&) noexcept;
  ~StepGraph();

  /// Runs the step, on all workers if that makes it faster. Only the first run on all of them
  /// allocates. If a phase throws, the nodes that have not started are cancelled and the exception
  /// is rethrown; the graph can run again.
  void run(Workers& workers);

  /// Runs the step on the calling thread in a legal order that `seed` selects.
  void run_serially(std::uint64_t seed);

  /// The phases, with the exchanges that they need, see with_exchanges.
  const std::vector<Phase>& phases() const { return phases_; }
  const Blocks& blocks() const { return blocks_; }
  const std::vector<std::string>& field_names() const { return field_names_; }
  const std::vector<Node>& nodes() const { return dependencies_.nodes; }
  const std::vector<Edge>& edges() const { return dependencies_.edges; }

  /// Names of the phases without repetition, in the order of their list, without exchanges.
  const std::vector<std::string>& timer_names() const { return timer_names_; }
  /// What runs have shown; a graph that replaces another one can take it over.
  const ParallelGain& parallel_gain() const { return gain_; }
  void set_parallel_gain(const ParallelGain& gain) { gain_ = gain; }

  const StepRecord& record() const { return record_; }
  StepRecord& record() { return record_; }

  /// The graph in the language of Graphviz, and as JSON: fields, phases, nodes, edges.
  std::string dot(Detail detail = Detail::blocks) const;
  std::string json() const;

  /// Edges between phases, merged from those between nodes; they number phases instead of nodes.
  /// Values of other blocks reach a phase by the exchange.
  std::vector<Edge> phase_edges() const;

 private:
  using Clock = std::chrono::steady_clock;

  // One (phase, block) call and its last times. It has its own cache line, since neighbours run at
  // the same time.
  struct alignas(64) Task {
    const std::function<void(BlockId)>* run;
    BlockId block;
    int worker;
    Clock::time_point start, stop;
    Task* next;  // in its chain

    void operator()(int on_worker);
  };
  struct Flow;

  void run_on(const Workers& workers);
  void run_in_parallel(const Workers& workers);
  void run_in_order(int worker);
  void run_through(NodeRunner& runner);
  void name_timers();
  void print_phases(std::string& out) const;
  void print_blocks(std::string& out) const;
  void finish_record(Clock::time_point start, int workers);

  std::vector<Phase> phases_;
  Blocks blocks_;
  std::vector<std::string> field_names_;
  Dependencies dependencies_;
  std::vector<std::string> timer_names_;
  std::vector<int> timer_of_phase_;
  std::vector<Task> tasks_;  // [node]
  StepRecord record_;
  ParallelGain gain_;
  std::unique_ptr<Flow> flow_;  // for the last workers
};

}  // namespace pliant::scheduler
