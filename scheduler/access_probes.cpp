#include "scheduler/access_probes.hpp"

#include <functional>

namespace pliant::scheduler {

FieldMemory CountingProbe::memory_of(const StepGraph& graph, FieldId field, BlockId block) const {
  FieldMemory memory;
  memory_(graph, field, block, memory);
  return memory;
}

std::size_t CountingProbe::fingerprint_of_writes(const StepGraph& graph,
                                                 const Declared& declared) const {
  std::size_t fingerprint = 0;
  const std::hash<std::string_view> hash;
  for_each_field_and_block(graph, [&](FieldId field, BlockId block) {
    if (!declared.writes(field, block)) return;
    const FieldMemory memory = memory_of(graph, field, block);
    for (const MemoryPiece& piece : memory.pieces())
      fingerprint = 1099511628211u * fingerprint + hash(view(piece));
  });
  return fingerprint;
}

ByteSet CountingProbe::bytes_of(const StepGraph& graph, const Declared& declared,
                                bool only_writes) const {
  ByteSet bytes;
  for_each_field_and_block(graph, [&](FieldId field, BlockId block) {
    if (only_writes ? declared.writes(field, block) : declared.accesses(field, block))
      bytes.add(memory_of(graph, field, block));
  });
  bytes.settle();
  return bytes;
}

namespace {

bool is_written(const Snapshot& before, const FieldMemory& after, const ByteSet& writable) {
  if (!before.has_places_of(after)) return true;
  std::size_t at = 0;
  for (const MemoryPiece& piece : after.pieces()) {
    for (std::size_t v = 0; v < piece.size; v += piece.value_size, at += piece.value_size) {
      if (std::memcmp(piece.data + v, before.bytes.data() + at, piece.value_size) != 0 &&
          !writable.meets(piece.data + v, piece.value_size))
        return true;
    }
  }
  return false;
}

}  // namespace

void Recorder::run(const StepGraph& graph, const Node& node, std::size_t) {
  const Declared declared(graph, node);
  const ByteSet writable = bytes_of(graph, declared, true);
  std::vector<Snapshot> before;
  for_each_field_and_block(graph, [&](FieldId field, BlockId block) {
    if (declared.writes(field, block)) return;
    before.push_back({field, block, {}, {}});
    before.back().take(memory_of(graph, field, block));
  });
  declared.phase().run(node.block);
  for (const Snapshot& snapshot : before) {
    if (is_written(snapshot, memory_of(graph, snapshot.field, snapshot.block), writable))
      note(graph, declared, node, snapshot);
  }
  nodes_.push_back({label(declared.phase()), fingerprint_of_writes(graph, declared)});
}

void Recorder::note(const StepGraph& graph, const Declared& declared, const Node& node,
                    const Snapshot& written) {
  const UndeclaredAccess access = {
      UndeclaredAccess::Kind::write, label(declared.phase()), node.block,
      graph.field_names()[static_cast<std::size_t>(written.field)], written.block};
  if (written_.insert({access.phase, written.field}).second) writes_.push_back(access);
}

void Disturber::run(const StepGraph& graph, const Node& node, std::size_t number) {
  const Declared declared(graph, node);
  const ByteSet usable = bytes_of(graph, declared, false);
  const std::vector<Snapshot> undisturbed = disturb(graph, declared, usable);
  bool deviates = false;
  try {
    declared.phase().run(node.block);
  } catch (...) {
    deviates = true;  // the node threw, which it did not when nothing was disturbed
  }
  for (const Snapshot& snapshot : undisturbed) restore(graph, snapshot, usable);
  deviates = deviates || fingerprint_of_writes(graph, declared) != nodes_.at(number).fingerprint;
  if (deviates)
    deviation_ = {number, label(declared.phase()), node.block, graph.field_names(),
                  graph.blocks().count()};
  if (deviates || number == disturbance_.last_node) throw Stop();
}

// Returns the former contents of the memory.
std::vector<Snapshot> Disturber::disturb(const StepGraph& graph, const Declared& declared,
                                         const ByteSet& usable) const {
  const std::string phase = label(declared.phase());
  std::vector<Snapshot> undisturbed;
  for_each_field_and_block(graph, [&](FieldId field, BlockId block) {
    if (declared.accesses(field, block)) return;
    if (!disturbance_.includes(phase, field, block)) return;
    const FieldMemory memory = memory_of(graph, field, block);
    undisturbed.push_back({field, block, {}, {}});
    undisturbed.back().take(memory);
  });
  for (const Snapshot& snapshot : undisturbed) {
    std::size_t at = 0;
    for (const MemoryPiece& piece : snapshot.pieces) {
      for (std::size_t v = 0; v < piece.size; v += piece.value_size, at += piece.value_size) {
        // Values shared by several fields are disturbed only once.
        const bool is_disturbed =
            std::memcmp(piece.data + v, snapshot.bytes.data() + at, piece.value_size) != 0;
        if (piece.disturb != nullptr && !is_disturbed &&
            !usable.meets(piece.data + v, piece.value_size))
          piece.disturb(piece.data + v);
      }
    }
  }
  return undisturbed;
}

// Values that the node has written stay; the recorder has recorded them.
void Disturber::restore(const StepGraph& graph, const Snapshot& snapshot,
                        const ByteSet& usable) const {
  if (!snapshot.has_places_of(memory_of(graph, snapshot.field, snapshot.block))) return;
  std::size_t at = 0;
  for (const MemoryPiece& piece : snapshot.pieces) {
    for (std::size_t v = 0; v < piece.size; v += piece.value_size, at += piece.value_size) {
      if (piece.disturb == nullptr || usable.meets(piece.data + v, piece.value_size)) continue;
      std::byte disturbed[16];
      std::memcpy(disturbed, snapshot.bytes.data() + at, piece.value_size);
      piece.disturb(disturbed);
      if (std::memcmp(piece.data + v, disturbed, piece.value_size) == 0)
        std::memcpy(piece.data + v, snapshot.bytes.data() + at, piece.value_size);
    }
  }
}

}  // namespace pliant::scheduler
