#pragma once

#include "kernels/remeshed/stage/chunk.hpp"
#include "kernels/remeshed/stage/fourth_difference.hpp"

/// Gradients of a field from differences along lattice lines. For the drift they are F - I since
/// the last remeshing, (RP.39).
namespace pliant::kernels {

/// Which of the two neighbours along a line are interior particles, 1 or 0, and the weight of each
/// in their mean.
template <class P>
struct LineNeighbours {
  P before, after, share;

  void find(const Mark* interior, const LineOffsets& line) {
    using T = Scalar<P>;
    before = load_marks<P>(interior + line.away[1]);
    after = load_marks<P>(interior + line.away[2]);
    // 1 over the number of these neighbours; 1 if there is none.
    share = fused_minus(P(T(0.5)), xsimd::max(before + after, P(T(1))), P(T(1.5)));
  }
};

/// df/da at a register of slots [1/h]: the mean of the differences to the two neighbours along the
/// line, as far as they are interior particles.
template <class P>
inline P line_derivative(const Scalar<P>* field, const LineNeighbours<P>& neighbours,
                         const LineOffsets& line) {
  const P value = load<P>(field);
  return neighbours.share * fused(neighbours.after, load<P>(field + line.away[2]) - value,
                                  neighbours.before * (value - load<P>(field + line.away[1])));
}

/// Largest abs(grad f)_F^2 of a chunk's interior particles, lane by lane [1/h^2].
template <class P, int D>
P largest_gradient2(const std::array<const Scalar<P>*, D>& field, const Mark* interior,
                    const Segment<D>& segment, const Chunk& chunk, P largest2) {
  LineOffsets line[D];
  for (int axis = 0; axis < D; ++axis) {
    line[axis] = line_offsets<typename P::arch_type>(segment, axis);
  }
  const P zero(Scalar<P>(0));
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    LineNeighbours<P> neighbours[D];
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) neighbours[j].find(interior + slot, line[j]);
    P norm2 = zero;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) {
        const P slope = line_derivative<P>(field[i] + slot, neighbours[j], line[j]);
        norm2 = fused(slope, slope, norm2);
      }
    }
    largest2 = xsimd::max(largest2, xsimd::select(interior_lanes<P>(interior, slot), norm2, zero));
  }
  return largest2;
}

template <class P, int D>
double lattice_gradient(const LatticeField<Scalar<P>, D>& block) {
  P largest2(Scalar<P>(0));
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    for (int begin = 0; begin < segment.count; begin += slots_per_pack) {
      const Chunk chunk{segment.first + begin, slots_per_pack};
      if (!holds_interior(block.pack_state[chunk.first / slots_per_pack])) continue;
      largest2 = largest_gradient2<P, D>(block.field, block.interior, segment, chunk, largest2);
    }
  }
  return square_root<P>(largest(largest2)) / block.spacing;
}

}  // namespace pliant::kernels
