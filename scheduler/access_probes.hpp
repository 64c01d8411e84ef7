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

/// Numbers the nodes that it observes, over all graphs of an experiment.
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
  /// The declared memory of a node. Memory shared by several fields counts if one of them is
  /// declared.
  ByteSet bytes_of(const StepGraph& graph, const Declared& declared, bool only_writes) const;

 private:
  std::size_t number_ = 0;
};

/// A phase by its label, and a field; `every` means all its fields.
using PhaseAndField = std::pair<std::string, FieldId>;
inline constexpr int every = -1;

/// A node as it ran.
struct Recorded {
  std::string phase;        ///< its label
  std::size_t fingerprint;  ///< of what it wrote
};

/// Records what nodes write, and finds undeclared writes.
class Recorder final : public CountingProbe {
 public:
  const std::vector<Recorded>& nodes() const { return nodes_; }
  const std::vector<UndeclaredAccess>& writes() const { return writes_; }
  const std::set<PhaseAndField>& written() const { return written_; }  ///< undeclared writes

 private:
  void run(const StepGraph& graph, const Node& node, std::size_t number) override;
  void note(const StepGraph& graph, const Declared& declared, const Node& node,
            const Snapshot& written);

  std::vector<Recorded> nodes_;
  std::vector<UndeclaredAccess> writes_;
  std::set<PhaseAndField> written_;
};

/// A node whose writes changed because values were disturbed.
struct Deviation {
  std::size_t number;
  std::string phase;
  BlockId block;
  std::vector<std::string> fields;  // [field] names
  int blocks;
};

/// The values that a disturber changes.
struct Disturbance {
  std::string phase = {};  ///< label; empty: every phase
  FieldId field = every;
  BlockId block = every;
  std::size_t last_node = std::numeric_limits<std::size_t>::max();  ///< later nodes do not run
  std::set<PhaseAndField> spared = {};

  bool includes(const std::string& of_phase, FieldId f, BlockId b) const {
    return (phase.empty() || phase == of_phase) && (field == every || field == f) &&
           (block == every || block == b) && spared.count({of_phase, f}) == 0 &&
           spared.count({of_phase, every}) == 0;
  }
};

/// Changes values that nodes have not declared, and stops at the first node whose writes differ.
class Disturber final : public CountingProbe {
 public:
  Disturber(const Disturbance& disturbance, const std::vector<Recorded>& nodes)
      : disturbance_(disturbance), nodes_(nodes) {}

  /// Ends an experiment whose rest does not matter.
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
