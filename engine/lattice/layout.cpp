#include "engine/lattice/layout.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pliant {

namespace {

// Rows of a 3D body are stored in square tiles with this many rows on each side.
constexpr int row_tile = 8;
// Longer segments are divided, so that no block of a wide body is one endless row.
constexpr int longest_segment = 64 * Occupancy<2>::pack;

int tile_of(std::int32_t row) {
  return row >= 0 ? row / row_tile : -((row_tile - 1 - row) / row_tile);
}

}  // namespace

template <int D>
void Layout<D>::build(const Occupancy<D>& occupancy, const Cell<D>& period, int block_count,
                      int block_reach) {
  occupancy_ = occupancy;
  period_ = period;
  block_reach_ = block_reach;
  find_runs();
  place_runs();
  cut_segments();
  group_blocks(block_count);
  connect_blocks(block_reach, neighbours_);
}

template <int D>
Cell<D> Layout<D>::cell(std::int64_t slot) const {
  const auto after = std::upper_bound(
      segments_.begin(), segments_.end(), slot,
      [](std::int64_t s, const kernels::Segment<D>& segment) { return s < segment.first; });
  const kernels::Segment<D>& segment = *std::prev(after);
  Cell<D> cell = segment.cell;
  cell[0] += static_cast<std::int32_t>(slot - segment.first);
  return cell;
}

template <int D>
void Layout<D>::find_runs() {
  runs_.clear();
  row_begin_.clear();
  for (int row = 0; row < occupancy_.rows(); ++row) {
    row_begin_.push_back(static_cast<int>(runs_.size()));
    occupancy_.for_each_run(row, [this](std::int32_t cell, std::int32_t count) {
      runs_.push_back({0, cell, count});
    });
  }
  row_begin_.push_back(static_cast<int>(runs_.size()));
}

template <int D>
void Layout<D>::place_runs() {
  row_order_.resize(occupancy_.rows());
  std::iota(row_order_.begin(), row_order_.end(), 0);
  if constexpr (D == 3) {
    std::sort(row_order_.begin(), row_order_.end(), [this](int a, int b) {
      const Cell<D> p = occupancy_.row_cell(a), q = occupancy_.row_cell(b);
      return std::tuple(tile_of(p[2]), tile_of(p[1]), p[2], p[1]) <
             std::tuple(tile_of(q[2]), tile_of(q[1]), q[2], q[1]);
    });
  }
  std::int64_t next = padding;
  for (const int row : row_order_) {
    for (int r = row_begin_[row]; r < row_begin_[row + 1]; ++r) {
      runs_[r].first = next;
      next += runs_[r].count;
    }
  }
  slots_ = next + padding;
}

// The run of a row that overlaps the cells lower..upper (exclusive), plus those that kernels may
// load.
template <int D>
const typename Layout<D>::Run* Layout<D>::run_near(int row, std::int32_t lower,
                                                   std::int32_t upper) const {
  if (row < 0) return nullptr;
  for (int r = row_begin_[row]; r < row_begin_[row + 1]; ++r) {
    if (runs_[r].cell < upper && lower < runs_[r].cell + runs_[r].count) return &runs_[r];
  }
  return nullptr;
}

template <int D>
void Layout<D>::cut_segments() {
  segments_.clear();
  for (const int row : row_order_) {
    for (int r = row_begin_[row]; r < row_begin_[row + 1]; ++r) {
      cut_run(runs_[r], occupancy_.row_cell(row));
    }
  }
}

// A pack joins the segment before it if every neighbouring row continues its run. A row without
// slots nearby may have any offset: the values loaded are finite, and no interior particle reads
// them.
template <int D>
void Layout<D>::cut_run(const Run& run, Cell<D> row) {
  constexpr int reach = kernels::row_reach;
  constexpr int rows = kernels::neighbouring_rows<D>;
  std::array<bool, rows> last_exists = {};
  for (std::int32_t offset = 0; offset < run.count; offset += pack) {
    kernels::Segment<D> piece;
    piece.first = run.first + offset;
    piece.count = pack;
    piece.cell = row;
    piece.cell[0] = run.cell + offset;
    std::array<bool, rows> exists;
    bool joins = offset > 0 && segments_.back().count < longest_segment;
    for (int k = 0; k < rows; ++k) {
      Cell<D> other = row;
      other[1] += k % (2 * reach + 1) - reach;
      if constexpr (D == 3) other[2] += k / (2 * reach + 1) - reach;
      const Run* found =
          run_near(occupancy_.row_of(other), piece.cell[0] - reach, piece.cell[0] + pack + reach);
      exists[k] = found != nullptr;
      piece.neighbour_row[k] = exists[k] ? found->first - found->cell - (run.first - run.cell) : 0;
      joins = joins && (!exists[k] || !last_exists[k] ||
                        segments_.back().neighbour_row[k] == piece.neighbour_row[k]);
    }
    if (!joins) {
      segments_.push_back(piece);
      last_exists = exists;
      continue;
    }
    kernels::Segment<D>& last = segments_.back();
    last.count += pack;
    for (int k = 0; k < rows; ++k) {
      if (exists[k]) last.neighbour_row[k] = piece.neighbour_row[k];
      last_exists[k] = last_exists[k] || exists[k];
    }
  }
}

// A segment belongs to the block whose share of all slots contains its middle.
template <int D>
void Layout<D>::group_blocks(int block_count) {
  blocks_.clear();
  std::int64_t total = 0, before = 0, share = -1;
  for (const kernels::Segment<D>& segment : segments_) total += segment.count;
  for (int s = 0; s < static_cast<int>(segments_.size()); ++s) {
    const kernels::Segment<D>& segment = segments_[s];
    const std::int64_t own = (before + segment.count / 2) * block_count / total;
    before += segment.count;
    if (own != share) blocks_.push_back({s, 0, segment.first, 0, segment.cell, segment.cell});
    share = own;
    Block<D>& block = blocks_.back();
    ++block.segment_count;
    block.slot_count += segment.count;
    for (int a = 0; a < D; ++a) {
      const std::int32_t last = a == 0 ? segment.cell[0] + segment.count - 1 : segment.cell[a];
      block.lower[a] = std::min(block.lower[a], segment.cell[a]);
      block.upper[a] = std::max(block.upper[a], last);
    }
  }
}

// Blocks may also be neighbours across a period: the images at one end mirror the other end.
template <int D>
void Layout<D>::connect_blocks(int reach, std::vector<std::vector<int>>& neighbours) const {
  const int count = static_cast<int>(blocks_.size());
  neighbours.resize(count);
  for (int b = 0; b < count; ++b) {
    neighbours[b].clear();
    for (int other = 0; other < count; ++other) {
      bool near = other != b;
      for (int a = 0; near && a < D; ++a) {
        bool meets = false;
        for (int shift = -period_[a]; !meets && shift <= period_[a];
             shift += std::max(period_[a], 1)) {
          meets = blocks_[other].lower[a] + shift <= blocks_[b].upper[a] + reach &&
                  blocks_[b].lower[a] <= blocks_[other].upper[a] + shift + reach;
        }
        near = meets;
      }
      if (near) neighbours[b].push_back(other);
    }
  }
}

template class Layout<2>;
template class Layout<3>;

}  // namespace pliant
