#pragma once

#include <functional>
#include <string>

#include "scheduler/field_memory.hpp"
#include "scheduler/node_runner.hpp"
#include "scheduler/phase.hpp"
#include "scheduler/workers.hpp"

namespace pliant::scheduler {

/// An access of a phase to a field that it has not declared.
struct UndeclaredAccess {
  enum class Kind { read, write };

  Kind kind;
  std::string phase;    ///< its label
  BlockId block;        ///< block that the phase worked on; -1: unknown
  std::string field;    ///< the field that was read or written
  BlockId field_block;  ///< the block of that field; -1: several, none of which causes it alone

  friend bool operator==(const UndeclaredAccess&, const UndeclaredAccess&) = default;
};

/// Adds the present memory of a field in a block of a graph.
using FieldMemoryOf =
    std::function<void(const StepGraph& graph, FieldId field, BlockId block, FieldMemory& memory)>;

/// Runs the nodes of step graphs and observes their effect on the memory of fields.
class AccessProbe : public NodeRunner {
 public:
  /// From now on the probe runs the nodes of the workers' graphs. For a graph that is not to be
  /// observed, `memory` adds nothing.
  void watch(Workers& workers, FieldMemoryOf memory) {
    memory_ = std::move(memory);
    workers.delegate(this);
  }

 protected:
  FieldMemoryOf memory_;
};

}  // namespace pliant::scheduler
