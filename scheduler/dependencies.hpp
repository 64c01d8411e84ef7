#pragma once

#include <string>
#include <vector>

#include "scheduler/blocks.hpp"
#include "scheduler/phase.hpp"

namespace pliant::scheduler {

/// A phase on one block. A junction does no work: it stands between two sets of nodes of which each
/// in the second must follow each in the first, and so turns m n edges into m + n.
struct Node {
  int phase;      ///< position in the list of phases; a junction has that of the phase behind it
  BlockId block;  ///< negative for a junction

  bool is_junction() const { return block < 0; }
};

/// `to` starts after `from` has ended, because of what both do to `field`.
struct Edge {
  int from;
  int to;
  FieldId field;

  bool has_ends_of(const Edge& other) const { return from == other.from && to == other.to; }
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// Who waits for whom in a step.
struct Dependencies {
  std::vector<Node> nodes;  ///< every edge leads to a later node
  std::vector<Edge>
      edges;  ///< by `to`, then `from`; edges of equal ends, one a field, follow one another
};

/// Derives the edges from the accesses, per (phase, block): a reader follows the last writer, a
/// writer follows the last writer and all readers since. Edges that others imply are left out.
///
/// Throws std::invalid_argument for a field or block that does not exist, a write that reaches
/// neighbours, a phase without a function, an exchange that runs or writes, and for a phase whose
/// blocks access what another of its blocks writes.
Dependencies derive_dependencies(const std::vector<Phase>& phases, const Blocks& blocks,
                                 const std::vector<std::string>& field_names);

/// The same order of nodes that work with fewer edges: no edge that others imply, and no junction
/// that saves none.
Dependencies reduced(const Dependencies& all);

}  // namespace pliant::scheduler
