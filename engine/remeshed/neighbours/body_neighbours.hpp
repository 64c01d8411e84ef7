#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/blocks/cell_list.hpp"
#include "engine/lattice/lattice.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// The data of a particle in a neighbour search besides its position: its slot, and the cell of
/// that slot. In periodic directions the position is in the first period, and the cell is moved by
/// the same whole periods.
template <int D>
struct SlotLabel {
  Cell<D> cell;
  std::int32_t slot;
};

/// Positions of particles over h: the cell plus the drift from it.
template <int D>
using SlotList = CellList<double, D, SlotLabel<D>>;
template <int D>
using SlotSite = typename SlotList<D>::Site;

/// Periods of positions over h; 0 in directions that are not periodic.
template <int D>
Point<D> period_of(const Lattice<D>& lattice) {
  Point<D> period;
  for (int a = 0; a < D; ++a) period[a] = lattice.period[a];
  return period;
}

/// The results of a search by position for one block.
template <int D>
struct BlockNeighbours {
  std::vector<SlotSite<D>> sites;  ///< of the block's own particles and ghosts
  Point<D> lower, upper;           ///< of their places, over h
  double closest = 0;  ///< distance of a particle from a slot just outside its stencil, over h
  /// Whether any particle has a neighbour outside its stencil. If not, the stencil is used.
  bool are_listed = false;
  std::vector<std::int32_t> slot;                   ///< of a neighbour
  std::array<std::vector<std::int32_t>, D> offset;  ///< from the particle to it [cells]
};

/// How long the stencil contains all neighbours of a body's particles, and those outside it.
template <int D>
struct BodyNeighbours {
  double strain = 0;       ///< sum of dt max abs(eps)_F since the last remeshing, of this body
  double strain_rate = 0;  ///< max abs(eps)_F in the last step [1/s]

  bool are_listed = false;    ///< whether neighbours are lists from a search; else the stencil
  double complete_until = 0;  ///< strain from which they may be incomplete, (RP.24)
  double coming_strain = 0;   ///< allowed until the next step
  bool is_measuring_due = false, is_search_due = false;

  double radius = 0;  ///< of the search, over h
  SlotList<D> cells;
  std::vector<BlockNeighbours<D>> blocks;
  std::vector<std::int64_t> start;   ///< [pack] into the lists of its block
  std::vector<std::int32_t> length;  ///< [pack]

  /// Lists of a block, for the kernels.
  kernels::NeighbourLists<D> lists(int block) const {
    const BlockNeighbours<D>& own = blocks[block];
    kernels::NeighbourLists<D> view{start.data(), length.data(), own.slot.data(), {}};
    for (int a = 0; a < D; ++a) view.offset[a] = own.offset[a].data();
    return view;
  }

  std::size_t bytes() const {
    std::size_t sum =
        cells.bytes() + start.capacity() * sizeof(start[0]) + length.capacity() * sizeof(length[0]);
    for (const BlockNeighbours<D>& own : blocks) {
      sum += own.sites.capacity() * sizeof(SlotSite<D>) + own.slot.capacity() * sizeof(own.slot[0]);
      for (const auto& component : own.offset) sum += component.capacity() * sizeof(component[0]);
    }
    return sum;
  }
};

}  // namespace pliant::remeshed
