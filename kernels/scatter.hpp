#pragma once

#include "kernels/m4prime.hpp"
#include "kernels/table.hpp"

/// M4' scatter of one block's particles onto the nodes of a tile.
///
/// Particles are prepared a pack at a time, lanes over particles: node positions, the 4 D factors
/// of the weights, and the values of NodeField without W. They are then added one by one, lanes
/// over the values of a node, so that each of the 4^D nodes takes a few aligned load-fma-stores.
namespace pliant::kernels {

/// True for slots that hold a particle of their own.
template <class P>
inline bool scatters(Kind kind) {
  return kind != Kind::vacant && kind != Kind::image;
}

/// A prepared storage pack, column by column.
template <class T, int D>
struct ScatterColumns {
  static constexpr int pack = slots_per_pack<T>;
  alignas(64) T cell[D][pack];       ///< whole cells that xi has gone, as a number
  alignas(64) T weight[D][4][pack];  ///< M4' factors
  alignas(64) T record[pack][node_width<D>];
};

/// Whole cells that the particles of a register have gone.
template <class P, int D>
inline void locate(const Scatter<Scalar<P>, D>& block, std::int64_t slot, int at,
                   ScatterColumns<Scalar<P>, D>& columns) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const P position = load<P>(block.state.displacement[i] + slot) * P(block.inverse_spacing);
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
    const P xi = load<P>(block.state.displacement[i] + slot);
    put(Field::momentum + i, m * load<P>(block.state.velocity[i] + slot));
    put(Field::carried + i, v * (load<P>(block.carried[i] + slot) + xi));
    P weight[4];
    m4prime(xi * P(block.inverse_spacing) - P::load_aligned(&columns.cell[i][at]), weight);
    for (int k = 0; k < 4; ++k) weight[k].store_aligned(&columns.weight[i][k][at]);
  }
  for (int c = 0; c < block.carried_components; ++c) {
    put(Field::material + c, v * load<P>(block.state.material[c] + slot));
  }
  const int fields = Field::material + block.carried_components;
  for (int l = 0; l < lanes<P>; ++l) {
    for (int f = 0; f < fields; ++f) columns.record[at + l][f] = value[f][l];
  }
}

/// The nodes of a particle, along each axis, that lie in the tile.
template <class P, int D>
struct NodeRange {
  int begin[3] = {0, 0, 0}, end[3] = {1, 1, 1};  ///< of its four
  std::int64_t first = 0;                        ///< offset of the first of its four, maybe outside
  bool is_empty = false;
};

template <class P, int D>
inline NodeRange<P, D> nodes_of(const Scatter<Scalar<P>, D>& block, const Segment<D>& segment,
                                int along_row, int lane, const std::int64_t (&stride)[D],
                                const ScatterColumns<Scalar<P>, D>& columns) {
  NodeRange<P, D> range;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const std::int32_t first = segment.cell[i] + (i == 0 ? along_row : 0) + block.shift[i] -
                               block.lower[i] + static_cast<std::int32_t>(columns.cell[i][lane]) -
                               1;
    range.begin[i] = first < 0 ? -first : 0;
    range.end[i] = first + 4 > block.extent[i] ? block.extent[i] - first : 4;
    range.is_empty = range.is_empty || range.begin[i] >= range.end[i];
    range.first += first * stride[i];
  }
  return range;
}

/// Adds lane `l` of a prepared pack.
template <int width, class P, int D>
inline void add_to_nodes(const ScatterColumns<Scalar<P>, D>& columns, int l,
                         const NodeRange<P, D>& range, const std::int64_t (&stride)[D],
                         Scalar<P>* nodes) {
  using T = Scalar<P>;
  constexpr int registers = width / lanes<P>;
  P record[registers];
#pragma GCC unroll 16
  for (int r = 0; r < registers; ++r) {
    record[r] = P::load_aligned(&columns.record[l][r * lanes<P>]);
  }
  for (int z = range.begin[2]; z < range.end[2]; ++z) {
    for (int y = range.begin[1]; y < range.end[1]; ++y) {
      T* row = nodes + range.first + y * stride[1];
      T factor = columns.weight[1][y][l];
      if constexpr (D == 3) {
        row += z * stride[2];
        factor *= columns.weight[2][z][l];
      }
      for (int x = range.begin[0]; x < range.end[0]; ++x) {
        const P weight(factor * columns.weight[0][x][l]);
#pragma GCC unroll 16
        for (int r = 0; r < registers; ++r) {
          T* sum = row + x * width + r * lanes<P>;
          fused(weight, record[r], load<P>(sum)).store_unaligned(sum);
        }
      }
    }
  }
}

template <int width, class P, int D>
void scatter_in(const Scatter<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  constexpr int pack = slots_per_pack<T>;
  ScatterColumns<T, D> columns;
  for (int l = 0; l < pack; ++l) {
    for (int f = 0; f < node_width<D>; ++f) columns.record[l][f] = 0;
  }
  std::int64_t stride[D];
  stride[0] = width;
  for (int i = 1; i < D; ++i) stride[i] = stride[i - 1] * block.extent[i - 1];
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    for (int begin = 0; begin < segment.count; begin += pack) {
      const Kind* kind = block.kind + segment.first + begin;
      for (int at = 0; at < pack; at += lanes<P>) {
        locate<P, D>(block, segment.first + begin + at, at, columns);
      }
      NodeRange<P, D> range[pack];
      bool touches = false;
      for (int l = 0; l < pack; ++l) {
        range[l] = nodes_of<P, D>(block, segment, begin + l, l, stride, columns);
        range[l].is_empty = range[l].is_empty || !scatters<P>(kind[l]);
        touches = touches || !range[l].is_empty;
      }
      if (!touches) continue;
      for (int at = 0; at < pack; at += lanes<P>) {
        prepare_scatter<P, D>(block, segment.first + begin + at, at, columns);
      }
      for (int l = 0; l < pack; ++l) {
        if (range[l].is_empty) continue;
        add_to_nodes<width, P, D>(columns, l, range[l], stride, block.nodes);
      }
    }
  }
}

/// See Scatter, (RP.21) and (RP.22).
template <class P, int D>
void scatter(const Scatter<Scalar<P>, D>& block) {
  constexpr int symmetric = node_width_for<D>(symmetric_components<D>);
  if (4 + 2 * D + block.carried_components <= symmetric) {
    scatter_in<symmetric, P, D>(block);
  } else {
    scatter_in<node_width<D>, P, D>(block);
  }
}

}  // namespace pliant::kernels
