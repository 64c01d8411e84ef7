#include "engine/total_lagrangian/block_cells.hpp"

#include <algorithm>
#include <tuple>

// A block evaluates every cell with one of its particles as a corner, also cells of other blocks.
// The corners of a pack of cells form up to four rows of particles; at the edge of a block only
// some of them belong to it.
namespace pliant::total_lagrangian {

namespace {

constexpr int pack = kernels::slots_per_pack;

/// A pack of cells and one row of its corners that belongs to the block.
struct PackAndRow {
  std::int64_t slot;
  int row;
  bool follows;  // whether the cell before the pack has corners in this row
};

template <class T, int D>
class BlockCellsFinder {
 public:
  BlockCellsFinder(const Body<T, D>& body, const Block<D>& block) : body_(body), block_(block) {}

  BlockCells<T, D> operator()() {
    collect();
    for (std::size_t i = 0; i < found_.size();) {
      kernels::CellRun<D> run = run_of(found_[i]);
      for (const std::int64_t slot = found_[i].slot; i < found_.size() && found_[i].slot == slot;
           ++i) {
        const int r = found_[i].row;
        run.target[r] = slot + run.row[r] - block_.first_slot;
      }
      append(run);
    }
    add_fitted();
    return std::move(cells_);
  }

 private:
  void collect() {
    const Layout<D>& layout = body_.layout;
    for (int s = 0; s < block_.segment_count; ++s) {
      const kernels::Segment<D>& segment = layout.segments_of(block_)[s];
      for (std::int32_t along = 0; along < segment.count; along += pack) {
        if (!holds_particle(segment.first + along)) continue;
        Cell<D> cell = segment.cell;
        cell[0] += along;
        collect_around(cell);
      }
    }
    std::sort(found_.begin(), found_.end(), [](const PackAndRow& a, const PackAndRow& b) {
      return std::tie(a.slot, a.row) < std::tie(b.slot, b.row);
    });
  }

  // Finds the packs of cells that have corners in the pack of particles at `cell`.
  void collect_around(const Cell<D>& cell) {
    for (int r = 0; r < kernels::corner_rows<D>; ++r) {
      Cell<D> at = cell;
      for (int a = 1; a < D; ++a) at[a] -= r >> (a - 1) & 1;
      const std::int64_t slot = body_.layout.slot(at);
      if (slot < 0) continue;
      --at[0];
      const std::int64_t before = body_.layout.slot(at);
      const bool follows = before >= 0 && body_.regular_fraction[before] > 0;
      if (follows || holds_cell(slot)) found_.push_back({slot, r, follows});
    }
  }

  bool holds_particle(std::int64_t slot) const {
    return std::any_of(&body_.mass[slot], &body_.mass[slot] + pack, [](T m) { return m > 0; });
  }
  bool holds_cell(std::int64_t slot) const {
    const T* const fraction = &body_.regular_fraction[slot];
    return std::any_of(fraction, fraction + pack, [](T f) { return f > 0; });
  }

  kernels::CellRun<D> run_of(const PackAndRow& found) const {
    kernels::CellRun<D> run = {};
    run.first = found.slot;
    run.count = pack;
    run.follows = found.follows;
    run.cut = is_cut(found.slot);
    run.own = found.slot >= block_.first_slot && found.slot < block_.first_slot + block_.slot_count;
    run.row = body_.corner_rows(found.slot);
    run.target.fill(-1);
    return run;
  }

  bool is_cut(std::int64_t slot) const { return body_.cut[slot / pack] != 0; }

  // A pack continues the run before it if their rows of corners are contiguous. No cell of the body
  // ends a lattice row, so a run may continue in the next one.
  void append(kernels::CellRun<D> next) {
    if (!cells_.runs.empty()) {
      kernels::CellRun<D>& last = cells_.runs.back();
      next.continues =
          last.first + last.count == next.first && last.own == next.own && last.row == next.row;
      for (int r = 0; r < kernels::corner_rows<D>; ++r) {
        next.continues = next.continues && (last.target[r] < 0) == (next.target[r] < 0);
      }
      if (next.continues && last.cut == next.cut) {
        last.count += pack;
        return;
      }
    }
    if (next.follows && !next.continues) next.cut = next.cut || is_cut(next.first - pack);
    cells_.runs.push_back(next);
  }

  bool has(std::int64_t slot) const {
    return slot >= block_.first_slot && slot < block_.first_slot + block_.slot_count;
  }

  void add_fitted() {
    for (const FittedCell<D>& cell : body_.fitted) {
      const Corners corners = corners_of(cell);
      if (std::none_of(corners.begin(), corners.end(),
                       [this](std::int64_t slot) { return has(slot); })) {
        continue;
      }
      if (cells_.fitted.empty() || cells_.fitted.back().count == pack) {
        cells_.fitted.emplace_back().count = 0;
      }
      kernels::FittedPack<T, D>& to = cells_.fitted.back();
      for (int lane = to.count; lane < pack; ++lane) put(cell, corners, lane, to);
      ++to.count;
    }
  }

  using Corners = std::array<std::int64_t, (1 << D)>;
  Corners corners_of(const FittedCell<D>& cell) const {
    const auto row = body_.corner_rows(cell.slot);
    Corners corners;
    for (int c = 0; c < (1 << D); ++c) corners[c] = cell.slot + row[c >> 1] + (c & 1);
    return corners;
  }

  // Lanes after that of the cell repeat it until the next cell takes their place.
  void put(const FittedCell<D>& cell, const Corners& corners, int lane,
           kernels::FittedPack<T, D>& to) const {
    to.slot[lane] = cell.slot;
    const CellMoments<D> moments = body_.moments(cell.slot);
    to.volume[lane] = static_cast<T>(cell.volume);
    to.moves[lane] = cell.moves ? T(1) : T(0);
    for (int c = 0; c < D * D; ++c) to.inverse[c][lane] = static_cast<T>(cell.inverse[c]);
    for (int c = 0; c < (1 << D); ++c) {
      const bool counts = lane == to.count && has(corners[c]);
      to.corner[c][lane] = corners[c];
      to.moment[c][lane] = static_cast<T>(moments[c]);
      to.target[c][lane] = counts ? static_cast<std::int32_t>(corners[c] - block_.first_slot) : -1;
      for (int i = 0; i < D; ++i) to.start[i][c][lane] = static_cast<T>(cell.start[i][c]);
    }
  }

  const Body<T, D>& body_;
  const Block<D>& block_;
  std::vector<PackAndRow> found_;
  BlockCells<T, D> cells_;
};

}  // namespace

template <class T, int D>
void find_block_cells(Body<T, D>& body) {
  body.cells.clear();
  body.cells.reserve(body.layout.blocks().size());
  for (const Block<D>& block : body.layout.blocks()) {
    body.cells.push_back(BlockCellsFinder<T, D>(body, block)());
  }
}

template void find_block_cells<double, 2>(Body<double, 2>&);
template void find_block_cells<double, 3>(Body<double, 3>&);
template void find_block_cells<float, 2>(Body<float, 2>&);
template void find_block_cells<float, 3>(Body<float, 3>&);

}  // namespace pliant::total_lagrangian
