#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scheduler/field_memory.hpp"
#include "scheduler/step_graph.hpp"

/// What the probes of an access check know about a node and its memory.
namespace pliant::scheduler {

/// The memory that a node has declared.
class Declared {
 public:
  Declared(const StepGraph& graph, const Node& node)
      : graph_(graph), node_(node), phase_(graph.phases()[static_cast<std::size_t>(node.phase)]) {}

  bool writes(FieldId field, BlockId block) const { return includes(phase_.writes, field, block); }
  bool accesses(FieldId field, BlockId block) const {
    return writes(field, block) || includes(phase_.reads, field, block);
  }
  const Phase& phase() const { return phase_; }

 private:
  bool includes(const std::vector<Access>& accesses, FieldId field, BlockId block) const {
    return std::any_of(accesses.begin(), accesses.end(), [&](const Access& access) {
      if (access.field != field) return false;
      if (access.reach == Reach::all || block == node_.block) return true;
      if (access.reach == Reach::own) return false;
      const auto& near = graph_.blocks().neighbours[static_cast<std::size_t>(node_.block)];
      return std::find(near.begin(), near.end(), block) != near.end();
    });
  }

  const StepGraph& graph_;
  const Node& node_;
  const Phase& phase_;
};

/// Calls f(field, block) for all fields and blocks of a graph.
template <class F>
void for_each_field_and_block(const StepGraph& graph, F&& f) {
  const auto fields = static_cast<FieldId>(graph.field_names().size());
  for (FieldId field = 0; field < fields; ++field)
    for (BlockId block = 0; block < std::max(graph.blocks().count(), 1); ++block) f(field, block);
}

inline std::string_view view(const MemoryPiece& piece) {
  return {reinterpret_cast<const char*>(piece.data), piece.size};
}

/// The contents of a field's memory in a block, and its location.
struct Snapshot {
  FieldId field;
  BlockId block;
  std::vector<MemoryPiece> pieces;
  std::string bytes;  // of all pieces

  void take(const FieldMemory& memory) {
    pieces = memory.pieces();
    bytes.clear();
    for (const MemoryPiece& piece : pieces) bytes += view(piece);
  }
  bool has_places_of(const FieldMemory& memory) const {
    return std::equal(pieces.begin(), pieces.end(), memory.pieces().begin(), memory.pieces().end(),
                      [](const MemoryPiece& a, const MemoryPiece& b) {
                        return a.data == b.data && a.size == b.size;
                      });
  }
};

/// A set of bytes in memory.
class ByteSet {
 public:
  void add(const FieldMemory& memory) {
    for (const MemoryPiece& piece : memory.pieces())
      ranges_.emplace_back(piece.data, piece.data + piece.size);
  }
  void settle() {
    std::sort(ranges_.begin(), ranges_.end());
    std::vector<Range> merged;
    for (const Range& range : ranges_) {
      if (merged.empty() || range.first > merged.back().second)
        merged.push_back(range);
      else
        merged.back().second = std::max(merged.back().second, range.second);
    }
    ranges_ = std::move(merged);
  }
  bool meets(const std::byte* data, std::size_t size) const {
    const auto after =
        std::upper_bound(ranges_.begin(), ranges_.end(), data,
                         [](const std::byte* at, const Range& range) { return at < range.second; });
    return after != ranges_.end() && after->first < data + size;
  }

 private:
  using Range = std::pair<const std::byte*, const std::byte*>;
  std::vector<Range> ranges_;
};

}  // namespace pliant::scheduler
