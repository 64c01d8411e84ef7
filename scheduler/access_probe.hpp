#pragma once

#include <functional>
#include <string>

#include "scheduler/field_memory.hpp"
#include "scheduler/node_runner.hpp"
#include "scheduler/phase.hpp"
#include "scheduler/workers.hpp"

namespace pliant::scheduler {

/// Something that a phase did to a field without having declared it.
struct UndeclaredAccess {
  enum class Kind { read, write };

  Kind kind;
  std::string phase;    ///< its label
  BlockId block;        ///< that the phase worked on; -1: not known
  std::string field;    ///< what was read or written
  BlockId field_block;  ///< and of which block; -1: of several, of which no one alone shows it

  friend bool operator==(const UndeclaredAccess&, const UndeclaredAccess&) = default;
};

/// Adds the memory of a field in a block of a graph, as it is at the moment.
using FieldMemoryOf =
    std::function<void(const StepGraph& graph, FieldId field, BlockId block, FieldMemory& memory)>;

/// Runs the nodes of step graphs and looks at what they do to the memory of fields.
class AccessProbe : public NodeRunner {
 public:
  /// From now on the workers leave the nodes of their graphs to the probe. A graph whose fields
  /// are to be left alone has no memory.
  void watch(Workers& workers, FieldMemoryOf memory) {
    memory_ = std::move(memory);
    workers.delegate(this);
  }

 protected:
  FieldMemoryOf memory_;
};

}  // namespace pliant::scheduler
