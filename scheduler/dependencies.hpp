#pragma once

#include <string>
#include <vector>

#include "scheduler/blocks.hpp"
#include "scheduler/phase.hpp"

namespace pliant::scheduler {

/// A phase on one block. A junction does no work: between m nodes and n nodes that must all follow
/// them, it replaces m n edges by m + n.
struct Node {
  int phase;      ///< position in the list of phases; for a junction, that of the phase after it
  BlockId block;  ///< negative for a junction

  bool is_junction() const { return block < 0; }
};

/// `to` starts after `from` has ended, because both access `field`.
struct Edge {
  int from;
  int to;
  FieldId field;

  bool has_ends_of(const Edge& other) const { return from == other.from && to == other.to; }
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// The nodes of a step, and which of them must wait for which.
struct Dependencies {
  std::vector<Node> nodes;  ///< every edge leads to a later node
  std::vector<Edge> edges;  ///< sorted by `to`, then `from`; edges with the same ends, one for each
                            ///< field, are adjacent
};

/// Derives the edges from the accesses, per (phase, block): a reader follows the last writer, a
/// writer follows the last writer and all readers since. Implied edges are left out.
///
/// Throws std::invalid_argument for a field or block that does not exist, a write that reaches
/// neighbours, a phase without a function, an exchange that runs or writes, and a phase in which a
/// block accesses what another block of the phase writes.
Dependencies derive_dependencies(const std::vector<Phase>& phases, const Blocks& blocks,
                                 const std::vector<std::string>& field_names);

/// The same order of nodes with fewer edges: without implied edges and without junctions that save
/// none.
Dependencies reduced(const Dependencies& all);

}  // namespace pliant::scheduler
