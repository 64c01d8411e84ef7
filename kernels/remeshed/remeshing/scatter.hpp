#pragma once

#include "kernels/remeshed/remeshing/arguments.hpp"
#include "kernels/remeshed/remeshing/m4prime.hpp"

/// M4' scatter of the particles of one block to the nodes of a tile.
///
/// Particles are prepared a pack at a time, with one particle in each lane: node positions, the 4 D
/// factors of the weights, and the values of a node without W. They are then added one by one, with
/// one value of a node in each lane: a few aligned load-fma-stores for each of the 4^D nodes.
namespace pliant::kernels {

/// Whether a slot holds a particle that is not an image.
template <class P>
inline bool scatters(Kind kind) {
  return kind != Kind::vacant && kind != Kind::image;
}

/// A prepared storage pack, by columns.
template <class T, int D>
struct ScatterColumns {
  static constexpr int pack = slots_per_pack;
  alignas(64) T cell[D][pack];       ///< whole cells of the displacement xi, as a number
  alignas(64) T weight[D][4][pack];  ///< M4' factors
  alignas(64) T record[pack][node_width<D>];
};

/// Computes the whole cells by which the particles of a register have moved.
template <class P, int D>
inline void locate(const Scatter<Scalar<P>, D>& block, std::int64_t slot, int at,
                   ScatterColumns<Scalar<P>, D>& columns) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const P position = load<P>(block.state.drift[i] + slot) * P(block.inverse_spacing);
    xsimd::floor(position).store_aligned(&columns.cell[i][at]);
  }
}

template <class P, int D>
inline void prepare_scatter(const Scatter<Scalar<P>, D>& block, std::int64_t slot, int at,
                            ScatterColumns<Scalar<P>, D>& columns) {
  using T = Scalar<P>;
  using Field = NodeField<D>;
  alignas(64) T value[node_fields<D>][lanes<P>];
  const auto put = [&](int field, const P& x) { x.store_aligned(value[field]); };
  const P m = load<P>(block.mass + slot), v = load<P>(block.state.volume + slot);
  put(Field::weight, P(T(1)));
  put(Field::mass, m);
  put(Field::volume, v);
  put(Field::level_set, load<P>(block.level_set + slot));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const P xi = load<P>(block.state.drift[i] + slot);
    put(Field::momentum + i, m * load<P>(block.state.velocity[i] + slot));
    put(Field::displacement + i, v * (load<P>(block.displacement[i] + slot) + xi));
    P weight[4];
    m4prime(xi * P(block.inverse_spacing) - P::load_aligned(&columns.cell[i][at]), weight);
    for (int k = 0; k < 4; ++k) weight[k].store_aligned(&columns.weight[i][k][at]);
  }
  for (int c = 0; c < block.material_component_count; ++c) {
    put(Field::material + c, v * load<P>(block.state.material[c] + slot));
  }
  const int fields = Field::material + block.material_component_count;
  for (int l = 0; l < lanes<P>; ++l) {
    for (int f = 0; f < fields; ++f) columns.record[at + l][f] = value[f][l];
  }
}

/// The four nodes of a particle along each axis, and which of them are in the box around the tile.
template <class P, int D>
struct NodeRange {
  std::int32_t first[3] = {0, 0, 0};  ///< first of the four, from the lower corner
  std::int32_t begin[3] = {0, 0, 0}, end[3] = {1, 1, 1};  ///< those in the box, likewise
  bool is_empty = false;
};

template <class P, int D>
inline NodeRange<P, D> nodes_of(const Scatter<Scalar<P>, D>& block, const Segment<D>& segment,
                                int along_row, int lane,
                                const ScatterColumns<Scalar<P>, D>& columns) {
  NodeRange<P, D> range;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const std::int32_t first = segment.cell[i] + (i == 0 ? along_row : 0) + block.shift[i] -
                               block.lower[i] + static_cast<std::int32_t>(columns.cell[i][lane]) -
                               1;
    range.first[i] = first;
    range.begin[i] = first < 0 ? 0 : first;
    range.end[i] = first + 4 > block.extent[i] ? block.extent[i] : first + 4;
    range.is_empty = range.is_empty || range.begin[i] >= range.end[i];
  }
  return range;
}

template <class P, int D>
inline const NodeRow& row_at(const Scatter<Scalar<P>, D>& block, int y, int z) {
  return block.rows[static_cast<std::int64_t>(z) * block.extent[1] + y];
}

/// Whether any row of the tile has nodes in a range.
template <class P, int D>
inline bool meets_rows(const Scatter<Scalar<P>, D>& block, const NodeRange<P, D>& range) {
  for (int z = range.begin[2]; z < range.end[2]; ++z) {
    for (int y = range.begin[1]; y < range.end[1]; ++y) {
      const NodeRow& row = row_at<P>(block, y, z);
      if (row.begin < range.end[0] && range.begin[0] < row.end) return true;
    }
  }
  return false;
}

/// Extends a range to the smallest one that contains both.
template <class P, int D>
inline void unite(NodeRange<P, D>& all, const NodeRange<P, D>& other) {
  if (other.is_empty) return;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    all.begin[i] = all.is_empty || other.begin[i] < all.begin[i] ? other.begin[i] : all.begin[i];
    all.end[i] = all.is_empty || other.end[i] > all.end[i] ? other.end[i] : all.end[i];
  }
  all.is_empty = false;
}

/// Adds lane `l` of a prepared pack.
template <int width, class P, int D>
inline void add_to_nodes(const Scatter<Scalar<P>, D>& block,
                         const ScatterColumns<Scalar<P>, D>& columns, int l,
                         const NodeRange<P, D>& range) {
  using T = Scalar<P>;
  constexpr int registers = width / lanes<P>;
  P record[registers];
#pragma GCC unroll 16
  for (int r = 0; r < registers; ++r) {
    record[r] = P::load_aligned(&columns.record[l][r * lanes<P>]);
  }
  for (int z = range.begin[2]; z < range.end[2]; ++z) {
    for (int y = range.begin[1]; y < range.end[1]; ++y) {
      const NodeRow& row = row_at<P>(block, y, z);
      T factor = columns.weight[1][y - range.first[1]][l];
      if constexpr (D == 3) factor *= columns.weight[2][z - range.first[2]][l];
      const int begin = row.begin > range.begin[0] ? row.begin : range.begin[0];
      const int end = row.end < range.end[0] ? row.end : range.end[0];
      T* node = block.nodes + (row.first + begin - row.begin) * width;
      for (int x = begin; x < end; ++x, node += width) {
        const P weight(factor * columns.weight[0][x - range.first[0]][l]);
#pragma GCC unroll 16
        for (int r = 0; r < registers; ++r) {
          T* sum = node + r * lanes<P>;
          fused(weight, record[r], load<P>(sum)).store_unaligned(sum);
        }
      }
    }
  }
}

template <int width, class P, int D>
void scatter_in(const Scatter<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  constexpr int pack = slots_per_pack;
  ScatterColumns<T, D> columns;
  for (int l = 0; l < pack; ++l) {
    for (int f = 0; f < node_width<D>; ++f) columns.record[l][f] = 0;
  }
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    for (int begin = 0; begin < segment.count; begin += pack) {
      const Kind* kind = block.kind + segment.first + begin;
      for (int at = 0; at < pack; at += lanes<P>) {
        locate<P, D>(block, segment.first + begin + at, at, columns);
      }
      NodeRange<P, D> range[pack], all;
      all.is_empty = true;
      for (int l = 0; l < pack; ++l) {
        range[l] = nodes_of<P, D>(block, segment, begin + l, l, columns);
        range[l].is_empty = range[l].is_empty || !scatters<P>(kind[l]);
        unite(all, range[l]);
      }
      if (all.is_empty || !meets_rows(block, all)) continue;
      for (int at = 0; at < pack; at += lanes<P>) {
        prepare_scatter<P, D>(block, segment.first + begin + at, at, columns);
      }
      for (int l = 0; l < pack; ++l) {
        if (!range[l].is_empty) add_to_nodes<width, P, D>(block, columns, l, range[l]);
      }
    }
  }
}

/// See Scatter, (RP.31) and (RP.32).
template <class P, int D>
void scatter(const Scatter<Scalar<P>, D>& block) {
  constexpr int symmetric = node_width_for<D>(symmetric_components<D>);
  if (4 + 2 * D + block.material_component_count <= symmetric) {
    scatter_in<symmetric, P, D>(block);
  } else {
    scatter_in<node_width<D>, P, D>(block);
  }
}

}  // namespace pliant::kernels
