#pragma once

#include <vector>

#include "engine/remeshed/remeshing/layout_search.hpp"

namespace pliant::remeshed {

/// Fields of the old lattice in place of S or F in the sums of (RP.32).
template <class T, int D>
struct TransportedFields {
  int count;  ///< at least 1
  std::array<const T*, kernels::material_components<D>> field;
};

/// Nodes of a block of the new lattice, with the sums of (RP.32).
template <class T, int D>
class ScatterTile {
 public:
  void lay_out(const Layout<D>& layout, int block);

  /// Sums over the particles and ghosts of a body, in the order of its present blocks; `bounds` are
  /// those of the blocks.
  void fill(Body<T, D>& body, const std::vector<CellBounds<D>>& bounds,
            const TransportedFields<T, D>& carried, const kernels::RemeshedTable<T, D>& kernels);

  /// The sums of a node: see kernels::NodeField.
  const T* node(const Cell<D>& cell) {
    const kernels::NodeRow& own = row_of(cell);
    return nodes_.get() + (own.first + cell[0] - lower_[0] - own.begin) * width_;
  }

 private:
  kernels::NodeRow& row_of(const Cell<D>& cell) {
    std::size_t at = 0;
    for (int a = D - 1; a > 0; --a) at = at * extent_[a] + (cell[a] - lower_[a]);
    return rows_[at];
  }
  kernels::Scatter<T, D> scatter_of(Body<T, D>& body, const TransportedFields<T, D>& carried);
  CellBounds<D> periods_to(const CellBounds<D>& source, const Cell<D>& period) const;

  Buffer<T> nodes_;
  std::vector<kernels::NodeRow> rows_;  ///< [z][y] of the box around the block
  std::int64_t count_ = 0;              ///< nodes
  int width_ = 0;                       ///< values of a node
  Cell<D> lower_, extent_;              ///< of the box
};

extern template class ScatterTile<double, 2>;
extern template class ScatterTile<double, 3>;
extern template class ScatterTile<float, 2>;
extern template class ScatterTile<float, 3>;

}  // namespace pliant::remeshed
