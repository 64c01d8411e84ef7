#pragma once

#include <cstddef>
#include <exception>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scheduler/access_check.hpp"
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
  virtual void run(const StepGraph& graph, const Node& node, int number) = 0;

  FieldMemory memory_of(const StepGraph& graph, FieldId field, BlockId block) const;
  std::size_t fingerprint_of_writes(const StepGraph& graph, const Declared& declared) const;
  /// Memory that several fields share belongs to a phase that declares one of them.
  ByteSet bytes_of(const StepGraph& graph, const Declared& declared, bool only_writes) const;

 private:
  int number_ = 0;
};

/// A phase by its label, and a field; `every`: all its fields.
using PhaseAndField = std::pair<std::string, FieldId>;
inline constexpr int every = -1;

/// Notes what nodes write, and finds writes that they have not declared.
class Recorder final : public CountingProbe {
 public:
  const std::vector<std::size_t>& fingerprints() const { return fingerprints_; }  ///< [node]
  const std::vector<UndeclaredAccess>& writes() const { return writes_; }
  const std::set<PhaseAndField>& written() const { return written_; }  ///< the same

 private:
  void run(const StepGraph& graph, const Node& node, int number) override;
  void note(const StepGraph& graph, const Declared& declared, const Node& node,
            const Snapshot& written);

  std::vector<std::size_t> fingerprints_;
  std::vector<UndeclaredAccess> writes_;
  std::set<PhaseAndField> written_;
};

/// A node that has read something undeclared.
struct Deviation {
  int number;
  std::string phase;
  BlockId block;
  std::vector<std::string> fields;  // [field] names
  int blocks;
};

/// What a disturber disturbs.
struct Disturbance {
  int node = every;
  FieldId field = every;
  BlockId block = every;
  std::set<PhaseAndField> spared = {};

  bool includes(int number, const std::string& phase, FieldId f, BlockId b) const {
    return (node == every || node == number) && (field == every || field == f) &&
           (block == every || block == b) && spared.count({phase, f}) == 0 &&
           spared.count({phase, every}) == 0;
  }
};

/// Disturbs what nodes have not declared, and stops at the first node to which it makes a
/// difference.
class Disturber final : public CountingProbe {
 public:
  Disturber(const Disturbance& disturbance, const std::vector<std::size_t>& fingerprints)
      : disturbance_(disturbance), fingerprints_(fingerprints) {}

  /// Thrown through the experiment when the rest of it does not matter.
  struct Stop : std::exception {};

  const std::optional<Deviation>& deviation() const { return deviation_; }

 private:
  void run(const StepGraph& graph, const Node& node, int number) override;
  std::vector<Snapshot> disturb(const StepGraph& graph, const Declared& declared, int number,
                                const ByteSet& usable) const;
  void restore(const StepGraph& graph, const Snapshot& snapshot, const ByteSet& usable) const;

  const Disturbance& disturbance_;
  const std::vector<std::size_t>& fingerprints_;
  std::optional<Deviation> deviation_;
};

}  // namespace pliant::scheduler
