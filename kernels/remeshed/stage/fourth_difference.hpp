#pragma once

#include "kernels/marks.hpp"

namespace pliant::kernels {

/// Slots at -2, -1, 1 and 2 cells along an axis, relative to a slot.
struct LineOffsets {
  std::int64_t away[4];
};

template <class Arch, int D>
inline LineOffsets line_offsets(const Segment<D>& segment, int axis) {
  if (axis == 0) return {{-2, -1, 1, 2}};
  LineOffsets line;
  for (int k = 0; k < 4; ++k) {
    const int cells = k < 2 ? k - 2 : k - 1;
    line.away[k] =
        segment.neighbour_row[axis == 1 ? row_index<D>(cells, 0) : row_index<D>(0, cells)];
  }
  return line;
}

/// Which two fluxes of a slot along a line exist: to the next slot and from the one before.
template <class P>
struct Fluxes {
  typename P::batch_bool_type up, down;
};

/// delta^4 f along a line, at a register of slots, as the difference of two fluxes, which are third
/// differences. The flux out of a slot is the flux into the next one, so sums over slots are
/// conserved. Exactly zero where f is constant.
template <class P>
inline P fourth_difference(const Scalar<P>* centre, const LineOffsets& line,
                           const Fluxes<P>& fluxes) {
  const P three(Scalar<P>(3)), zero(Scalar<P>(0)), value = load<P>(centre);
  const P before = load<P>(centre + line.away[1]), after = load<P>(centre + line.away[2]);
  const P up = fused_minus(three, after - value, load<P>(centre + line.away[3]) - before);
  const P down = fused_minus(three, value - before, after - load<P>(centre + line.away[0]));
  return xsimd::select(fluxes.up, up, zero) - xsimd::select(fluxes.down, down, zero);
}

/// Fluxes between slots that are both inside (`inside` is 1 there, 0 elsewhere): none cross the
/// surface.
template <class P>
inline Fluxes<P> fluxes_between(const Mark* inside, const LineOffsets& line) {
  const P here = load_marks<P>(inside), half(Scalar<P>(0.5));
  return {here * load_marks<P>(inside + line.away[2]) > half,
          here * load_marks<P>(inside + line.away[1]) > half};
}

/// Fluxes whose four slots are all inside.
template <class P>
inline Fluxes<P> fluxes_within(const Scalar<P>* inside, const LineOffsets& line) {
  const P half(Scalar<P>(0.5));
  const P near = load<P>(inside) * load<P>(inside + line.away[1]) * load<P>(inside + line.away[2]);
  return {near * load<P>(inside + line.away[3]) > half,
          near * load<P>(inside + line.away[0]) > half};
}

/// Sums over the directions of delta^4 f where all fluxes exist.
template <class P, int D>
inline P fourth_differences_inside(const Scalar<P>* centre, const LineOffsets (&line)[D]) {
  using T = Scalar<P>;
  const P twice = P(T(2)) * load<P>(centre);
  P near(T(0)), far(T(0));
#pragma GCC unroll 3
  for (const LineOffsets& l : line) {
    near = near + (load<P>(centre + l.away[1]) + load<P>(centre + l.away[2]) - twice);
    far = far + (load<P>(centre + l.away[0]) + load<P>(centre + l.away[3]) - twice);
  }
  return fused_minus(P(T(4)), near, far);
}

/// The same with the given fluxes in each direction.
template <class P, int D>
inline P fourth_differences(const Scalar<P>* centre, const LineOffsets (&line)[D],
                            const Fluxes<P> (&fluxes)[D]) {
  P sum = fourth_difference<P>(centre, line[0], fluxes[0]);
#pragma GCC unroll 3
  for (int axis = 1; axis < D; ++axis) {
    sum = sum + fourth_difference<P>(centre, line[axis], fluxes[axis]);
  }
  return sum;
}

}  // namespace pliant::kernels
