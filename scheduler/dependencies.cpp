#include "scheduler/dependencies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "scheduler/ancestors.hpp"

// The derivation walks the phases in the order of their list. For each field and block (a cell) it
// keeps the last writer and the readers since:
//
//     phase      advance        exchange       advance
//     block 0    W ---------------> R . . . . . . > W       a read follows the last write (---),
//     block 1       `-------------> R . . . . . . > W       a write follows the reads (. .),
//                                                           or the last write if there are none.
//
// If k > 1 blocks each read the values of all blocks, the k readers share one junction before them,
// to which all writers lead, and one after them, from which later writers follow.
//
// Implied edges, which are the majority, are removed once all edges of their node are known. Those
// of junctions stay, since some junctions are removed in the end.
namespace pliant::scheduler {

namespace {

constexpr int nobody = -1;
constexpr BlockId no_block = -1;

struct Cell {
  int writer = nobody;
  std::vector<int> readers;  // since the last write, without the writer itself
};

class Derivation {
 public:
  Derivation(const std::vector<Phase>& phases, const Blocks& blocks,
             const std::vector<std::string>& field_names)
      : phases_(phases),
        blocks_(blocks),
        field_names_(field_names),
        // Reduce phases work on block 0 even if there are no blocks.
        cells_per_field_(std::max<std::size_t>(blocks.neighbours.size(), 1)),
        cells_(field_names.size() * cells_per_field_) {
    every_block_.resize(blocks.neighbours.size());
    std::iota(every_block_.begin(), every_block_.end(), 0);
  }

  Dependencies run() {
    for (int p = 0; p < static_cast<int>(phases_.size()); ++p) add_phase(p);
    return std::move(result_);
  }

 private:
  const std::vector<BlockId>& blocks_of(const Phase& phase) const {
    static const std::vector<BlockId> first_block{0}, none;
    if (phase.kind == Phase::Kind::reduce) return first_block;
    if (phase.kind == Phase::Kind::exchange) return none;
    return phase.blocks.empty() ? every_block_ : phase.blocks;
  }

  Cell& cell(FieldId field, BlockId block) {
    return cells_[static_cast<std::size_t>(field) * cells_per_field_ +
                  static_cast<std::size_t>(block)];
  }

  template <class Visit>
  void for_each_cell(const Access& access, BlockId block, Visit visit) {
    if (access.reach == Reach::all) {
      for (BlockId b = 0; b < static_cast<BlockId>(cells_per_field_); ++b)
        visit(cell(access.field, b), b);
      return;
    }
    visit(cell(access.field, block), block);
    if (access.reach == Reach::own || blocks_.neighbours.empty()) return;
    for (const BlockId b : blocks_.neighbours[static_cast<std::size_t>(block)])
      visit(cell(access.field, b), b);
  }

  int add_node(int phase, BlockId block) {
    result_.nodes.push_back({phase, block});
    return static_cast<int>(result_.nodes.size()) - 1;
  }

  // Edges of one node are added together, so sorting those of each node keeps the list sorted.
  void settle_edges(std::size_t first) {
    auto& edges = result_.edges;
    const auto begin = edges.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, edges.end());
    edges.erase(std::unique(begin, edges.end()), edges.end());
    ancestors_.add_node(edges, first, [this](const Edge& edge) {
      return result_.nodes[static_cast<std::size_t>(edge.from)].is_junction() ||
             result_.nodes[static_cast<std::size_t>(edge.to)].is_junction();
    });
  }

  void follow_writers(int node, const Access& read, BlockId block) {
    for_each_cell(read, block, [&](const Cell& c, BlockId) {
      if (c.writer != nobody) result_.edges.push_back({c.writer, node, read.field});
    });
  }

  void follow_readers(int node, const Access& write, BlockId block) {
    for_each_cell(write, block, [&](const Cell& c, BlockId) {
      for (const int reader : c.readers) result_.edges.push_back({reader, node, write.field});
      if (c.readers.empty() && c.writer != nobody)
        result_.edges.push_back({c.writer, node, write.field});
    });
  }

  void add_phase(int p) {
    const Phase& phase = phases_[static_cast<std::size_t>(p)];
    const auto& blocks = blocks_of(phase);
    std::vector<Access> own_reads, shared_reads;
    for (const Access& read : phase.reads)
      (blocks.size() > 1 && read.reach == Reach::all ? shared_reads : own_reads).push_back(read);

    const int first_junction = static_cast<int>(result_.nodes.size());
    for (const Access& read : shared_reads) {
      const int junction = add_node(p, no_block);
      const std::size_t first_edge = result_.edges.size();
      follow_writers(junction, read, 0);
      settle_edges(first_edge);
    }

    const int first_node = static_cast<int>(result_.nodes.size());
    for (const BlockId block : blocks) {
      const int node = add_node(p, block);
      const std::size_t first_edge = result_.edges.size();
      for (const Access& read : own_reads) follow_writers(node, read, block);
      for (const Access& write : phase.writes) follow_readers(node, write, block);
      for (int s = 0; s < static_cast<int>(shared_reads.size()); ++s)
        result_.edges.push_back(
            {first_junction + s, node, shared_reads[static_cast<std::size_t>(s)].field});
      settle_edges(first_edge);
    }

    record_writes(phase, first_node, blocks);
    for (const Access& read : own_reads) record_reads(phase, read, first_node, blocks);
    for (const Access& read : shared_reads) record_shared_read(p, read, first_node, blocks);
  }

  void record_writes(const Phase& phase, int first_node, const std::vector<BlockId>& blocks) {
    for (std::size_t n = 0; n < blocks.size(); ++n)
      for (const Access& write : phase.writes)
        for_each_cell(write, blocks[n], [&](Cell& c, BlockId b) {
          const int node = first_node + static_cast<int>(n);
          if (c.writer >= first_node && c.writer != node) refuse(phase, write.field, b, blocks[n]);
          c.writer = node;
          c.readers.clear();
        });
  }

  void record_reads(const Phase& phase, const Access& read, int first_node,
                    const std::vector<BlockId>& blocks) {
    for (std::size_t n = 0; n < blocks.size(); ++n)
      for_each_cell(read, blocks[n], [&](Cell& c, BlockId b) {
        const int node = first_node + static_cast<int>(n);
        if (c.writer == node) return;
        if (c.writer >= first_node) refuse(phase, read.field, b, blocks[n]);
        c.readers.push_back(node);
      });
  }

  void record_shared_read(int p, const Access& read, int first_node,
                          const std::vector<BlockId>& blocks) {
    const int junction = add_node(p, no_block);
    const std::size_t first_edge = result_.edges.size();
    for (int node = first_node; node < first_node + static_cast<int>(blocks.size()); ++node)
      result_.edges.push_back({node, junction, read.field});
    settle_edges(first_edge);
    for_each_cell(read, 0, [&](Cell& c, BlockId b) {
      if (c.writer >= first_node)
        refuse(phases_[static_cast<std::size_t>(p)], read.field, b, blocks[b == blocks[0] ? 1 : 0]);
      c.readers.push_back(junction);
    });
  }

  [[noreturn]] void refuse(const Phase& phase, FieldId field, BlockId written,
                           BlockId other) const {
    throw std::invalid_argument(
        fmt::format("phase {} writes {} of block {}, which its block {} accesses too, but the "
                    "blocks of a phase "
                    "run in any order: write another field, or make two phases of it",
                    label(phase), field_names_[static_cast<std::size_t>(field)], written, other));
  }

  const std::vector<Phase>& phases_;
  const Blocks& blocks_;
  const std::vector<std::string>& field_names_;
  std::size_t cells_per_field_;
  std::vector<Cell> cells_;
  std::vector<BlockId> every_block_;
  Dependencies result_;
  Ancestors ancestors_;
};

void check(const std::vector<Phase>& phases, const Blocks& blocks, int field_count) {
  const auto refuse = [](const Phase& phase, const std::string& what) {
    throw std::invalid_argument(fmt::format("phase {}: {}", label(phase), what));
  };
  for (const auto& neighbours : blocks.neighbours)
    for (const BlockId block : neighbours)
      if (block < 0 || block >= blocks.count())
        throw std::invalid_argument(
            fmt::format("block {} is a neighbour, but there are {} blocks", block, blocks.count()));
  for (const Phase& phase : phases) {
    const bool is_exchange = phase.kind == Phase::Kind::exchange;
    if (!is_exchange && !phase.run) refuse(phase, "has no function to run");
    if (is_exchange && (phase.run || !phase.writes.empty()))
      refuse(phase, "an exchange only sends what it reads: it neither runs nor writes");
    for (const auto* accesses : {&phase.reads, &phase.writes})
      for (const Access& access : *accesses)
        if (access.field < 0 || access.field >= field_count)
          refuse(phase, fmt::format("there is no field {}", access.field));
    for (const Access& write : phase.writes)
      if (write.reach == Reach::neighbours)
        refuse(phase, "a block may write its own values or, alone in its phase, all of them");
    for (const BlockId block : phase.blocks)
      if (block < 0 || block >= blocks.count())
        refuse(phase, fmt::format("there is no block {}", block));
    auto sorted = phase.blocks;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      refuse(phase, "a block is listed twice");
  }
}

}  // namespace

std::string label(const Phase& phase) {
  return phase.stage < 0 ? phase.name : fmt::format("{}[{}]", phase.name, phase.stage);
}

Dependencies derive_dependencies(const std::vector<Phase>& phases, const Blocks& blocks,
                                 const std::vector<std::string>& field_names) {
  check(phases, blocks, static_cast<int>(field_names.size()));
  return reduced(Derivation(phases, blocks, field_names).run());
}

}  // namespace pliant::scheduler
