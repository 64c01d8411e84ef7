#pragma once

#include <functional>
#include <string>
#include <vector>

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

/// "phase advance[0] on block 2 reads velocity of block 5 without declaring it".
std::string text(const UndeclaredAccess& access);

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

/// What phases read and write beyond their declarations, each (phase, field) once.
///
/// `experiment(probe)` must do the same each time: set up a state of its own, let the probe watch
/// the workers, and run steps. It is called several times.
///
/// A write is found by comparing memory before and after each node. A read is found by its effect:
/// all values that a node has not declared are disturbed while it runs, and what it writes must
/// stay bitwise the same. A value that is loaded but not used is no read. Works in every build.
///
/// Throws what the experiment throws when nothing is disturbed.
std::vector<UndeclaredAccess> undeclared_accesses(
    const std::function<void(AccessProbe& probe)>& experiment);

}  // namespace pliant::scheduler
