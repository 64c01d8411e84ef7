#pragma once

#include "kernels/remeshed/stage/fourth_difference.hpp"

namespace pliant::kernels {

/// Slots at -3 and 3 cells along an axis, relative to a slot.
struct FarOffsets {
  std::int64_t before, after;
};

template <int D>
inline FarOffsets far_offsets(const Segment<D>& segment, int axis) {
  if (axis == 0) return {-3, 3};
  const auto row = [&](int cells) {
    return segment.neighbour_row[axis == 1 ? row_index<D>(cells, 0) : row_index<D>(0, cells)];
  };
  return {row(-3), row(3)};
}

/// delta^6 f/4 along a line, with the sign that damps, at a register of slots: the difference of
/// two fluxes, which are fifth differences. If one of the six slots of a flux is not inside
/// (`inside` is 1 there, 0 elsewhere), third differences replace it, the flux of fourth_difference.
/// There is no flux between two slots that are not both inside.
template <class P>
inline P sixth_difference(const Scalar<P>* centre, const Mark* inside, const LineOffsets& line,
                          const FarOffsets& far) {
  using T = Scalar<P>;
  const P half(T(0.5)), zero(T(0)), three(T(3)), quarter(T(0.25)), five(T(5)), ten(T(10));
  const P value = load<P>(centre), here = load_marks<P>(inside);
  const P first = load<P>(centre + line.away[0]), before = load<P>(centre + line.away[1]);
  const P after = load<P>(centre + line.away[2]), last = load<P>(centre + line.away[3]);
  const P in_first = load_marks<P>(inside + line.away[0]),
          in_before = load_marks<P>(inside + line.away[1]);
  const P in_after = load_marks<P>(inside + line.away[2]),
          in_last = load_marks<P>(inside + line.away[3]);
  const P near = in_first * in_before * in_after * in_last * here;
  const auto wide_up = near * load_marks<P>(inside + far.after) > half;
  const auto wide_down = near * load_marks<P>(inside + far.before) > half;
  const P up3 = fused_minus(three, after - value, last - before);
  const P down3 = fused_minus(three, value - before, after - first);
  const P up5 =
      five * (last - before) - fused(ten, after - value, load<P>(centre + far.after) - first);
  const P down5 =
      five * (after - first) - fused(ten, value - before, last - load<P>(centre + far.before));
  const P up = xsimd::select(wide_up, quarter * up5, up3);
  const P down = xsimd::select(wide_down, quarter * down5, down3);
  return xsimd::select(here * in_after > half, up, zero) -
         xsimd::select(here * in_before > half, down, zero);
}

/// Sums over the directions where all fluxes are fifth differences.
template <class P, int D>
inline P sixth_differences_inside(const Scalar<P>* centre, const LineOffsets (&line)[D],
                                  const FarOffsets (&far)[D]) {
  using T = Scalar<P>;
  const P twice = P(T(2)) * load<P>(centre);
  P near(T(0)), middle(T(0)), outer(T(0));
#pragma GCC unroll 3
  for (int axis = 0; axis < D; ++axis) {
    const LineOffsets& l = line[axis];
    near = near + (load<P>(centre + l.away[1]) + load<P>(centre + l.away[2]) - twice);
    middle = middle + (load<P>(centre + l.away[0]) + load<P>(centre + l.away[3]) - twice);
    outer =
        outer + (load<P>(centre + far[axis].before) + load<P>(centre + far[axis].after) - twice);
  }
  return P(T(0.25)) * (fused(P(T(6)), middle, fused_minus(P(T(15)), near, P(T(0)) - outer)));
}

}  // namespace pliant::kernels
