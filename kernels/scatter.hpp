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
    const P position = xi * P(block.inverse_spacing);
    const P cell = xsimd::floor(position);
    P weight[4];
    m4prime(position - cell, weight);
    cell.store_aligned(&columns.cell[i][at]);
    for (int k = 0; k < 4; ++k) weight[k].store_aligned(&columns.weight[i][k][at]);
  }
  for (int c = 0; c < material_components<D>; ++c) {
    put(Field::material + c,
        c < block.carried_components ? v * load<P>(block.state.material[c] + slot) : P(T(0)));
  }
  for (int l = 0; l < lanes<P>; ++l) {
    for (int f = 0; f < node_fields<D>; ++f) columns.record[at + l][f] = value[f][l];
  }
}

/// Adds lane `l` of a prepared pack, its first node at `nodes`.
template <class P, int D>
inline void add_to_nodes(const ScatterColumns<Scalar<P>, D>& columns, int l,
                         const std::int64_t (&stride)[D], Scalar<P>* nodes) {
  using T = Scalar<P>;
  constexpr int registers = node_width<D> / lanes<P>;
  P record[registers];
#pragma GCC unroll 8
  for (int r = 0; r < registers; ++r) {
    record[r] = P::load_aligned(&columns.record[l][r * lanes<P>]);
  }
  for (int z = 0; z < (D == 3 ? 4 : 1); ++z) {
    for (int y = 0; y < 4; ++y) {
      T* row = nodes + y * stride[1];
      T factor = columns.weight[1][y][l];
      if constexpr (D == 3) {
        row += z * stride[2];
        factor *= columns.weight[2][z][l];
      }
      for (int x = 0; x < 4; ++x, row += node_width<D>) {
        const P weight(factor * columns.weight[0][x][l]);
#pragma GCC unroll 8
        for (int r = 0; r < registers; ++r) {
          T* sum = row + r * lanes<P>;
          fused(weight, record[r], load<P>(sum)).store_unaligned(sum);
        }
      }
    }
  }
}

/// See Scatter, (RP.21) and (RP.22).
template <class P, int D>
void scatter(const Scatter<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  constexpr int pack = slots_per_pack<T>;
  ScatterColumns<T, D> columns;
  for (int l = 0; l < pack; ++l) {
    for (int f = node_fields<D>; f < node_width<D>; ++f) columns.record[l][f] = 0;
  }
  std::int64_t stride[D];
  stride[0] = node_width<D>;
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) stride[i] = stride[i - 1] * block.extent[i - 1];
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    for (int begin = 0; begin < segment.count; begin += pack) {
      const Kind* kind = block.kind + segment.first + begin;
      bool occupied = false;
      for (int l = 0; l < pack; ++l) occupied = occupied || scatters<P>(kind[l]);
      if (!occupied) continue;
      for (int at = 0; at < pack; at += lanes<P>) {
        prepare_scatter<P, D>(block, segment.first + begin + at, at, columns);
      }
      for (int l = 0; l < pack; ++l) {
        bool inside = scatters<P>(kind[l]);
        std::int64_t node = 0;
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i) {
          const std::int32_t along_row = i == 0 ? begin + l : 0;
          const std::int32_t first = segment.cell[i] + along_row + block.shift[i] - block.lower[i] +
                                     static_cast<std::int32_t>(columns.cell[i][l]) - 1;
          inside = inside && first >= 0 && first + 4 <= block.extent[i];
          node += first * stride[i];
        }
        if (inside) add_to_nodes<P, D>(columns, l, stride, block.nodes + node);
      }
    }
  }
}

}  // namespace pliant::kernels
