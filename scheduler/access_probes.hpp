#pragma once

#include <cstddef>
#include <exception>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scheduler/access_probe.hpp"
#include "scheduler/node_memory.hpp"

/// The probes of an access check.
namespace pliant::scheduler {

/// Numbers the nodes that it sees through all graphs of an experiment.
class CountingProbe : public AccessProbe {
 public:
  void run(const StepGraph& graph, const Node& node) final {
    run(graph, node, number_);
    ++number_;
  }

 protected:
  virtual void run(const StepGraph& graph, const Node& node, std::size_t number) = 0;

  FieldMemory memory_of(const StepGraph& graph, FieldId field, BlockId block) const;
  std::size_t fingerprint_of_writes(const StepGraph& graph, const Declared& declared) const;
  /// Memory that several fields share belongs to a phase that declares one of them.
  ByteSet bytes_of(const StepGraph& graph, const Declared& declared, bool only_writes) const;

 private:
  std::size_t number_ = 0;
};

/// A phase by its label, and a field; `every`: all its fields.
using PhaseAndField = std::pair<std::string, FieldId>;
inline constexpr int every = -1;

/// A node that has run.
struct Recorded {
  std::string phase;        ///< its label
  std::size_t fingerprint;  ///< of what it wrote
};

/// Notes what nodes write, and finds writes that they have not declared.
class Recorder final : public CountingProbe {
 public:
  const std::vector<Recorded>& nodes() const { return nodes_; }
  const std::vector<UndeclaredAccess>& writes() const { return writes_; }
  const std::set<PhaseAndField>& written() const { return written_; }  ///< the same

 private:
  void run(const StepGraph& graph, const Node& node, std::size_t number) override;
  void note(const StepGraph& graph, const Declared& declared, const Node& node,
            const Snapshot& written);

  std::vector<Recorded> nodes_;
  std::vector<UndeclaredAccess> writes_;
  std::set<PhaseAndField> written_;
};

/// A node that has written something else because values were disturbed.
struct Deviation {
  std::size_t number;
  std::string phase;
  BlockId block;
  std::vector<std::string> fields;  // [field] names
  int blocks;
};

/// What a disturber disturbs.
struct Disturbance {
  std::string phase = {};  ///< label; empty: every phase
  FieldId field = every;
  BlockId block = every;
  std::size_t last_node = std::numeric_limits<std::size_t>::max();  ///< what follows does not run
  std::set<PhaseAndField> spared = {};

  bool includes(const std::string& of_phase, FieldId f, BlockId b) const {
    return (phase.empty() || phase == of_phase) && (field == every || field == f) &&
           (block == every || block == b) && spared.count({of_phase, f}) == 0 &&
           spared.count({of_phase, every}) == 0;
  }
};

/// Disturbs what nodes have not declared, and stops at the first node to which it makes a
/// difference.
class Disturber final : public CountingProbe {
 public:
  Disturber(const Disturbance& disturbance, const std::vector<Recorded>& nodes)
      : disturbance_(disturbance), nodes_(nodes) {}

  /// Thrown through the experiment when the rest of it does not matter.
  struct Stop : std::exception {};

  const std::optional<Deviation>& deviation() const { return deviation_; }

 private:
  void run(const StepGraph& graph, const Node& node, std::size_t number) override;
  std::vector<Snapshot> disturb(const StepGraph& graph, const Declared& declared,
                                const ByteSet& usable) const;
  void restore(const StepGraph& graph, const Snapshot& snapshot, const ByteSet& usable) const;

  const Disturbance& disturbance_;
  const std::vector<Recorded>& nodes_;
  std::optional<Deviation> deviation_;
};

}  // namespace pliant::scheduler
