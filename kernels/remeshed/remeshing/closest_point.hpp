#pragma once

#include "kernels/pack.hpp"
#include "kernels/remeshed/remeshing/arguments.hpp"
#include "kernels/remeshed/remeshing/cubic.hpp"

/// Closest points of a zero set by (RP.41), one node in each lane: see ClosestPoints.
namespace pliant::kernels {

/// The 4^D nodes around the points of a register. They are reused between iterations, which rarely
/// leave their cell. Nodes outside the box are NaN.
template <class P, int D>
class NodesAround {
  using T = Scalar<P>;

 public:
  explicit NodesAround(const ClosestPoints<T, D>& work) : work_(work) {
    for (auto& lane : base_) {
      for (T& cell : lane) cell = T(0.5);  // none
    }
  }

  /// Value and gradient at x.
  void interpolate(const P (&x)[D], P& value, P (&gradient)[D]) {
    P s[D];
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      const P cell = xsimd::floor(x[a]);
      s[a] = x[a] - cell;
      cell.store_aligned(cell_[a]);
    }
    for (int l = 0; l < lanes<P>; ++l) {
      if (has_left(l)) load_nodes(l);
    }
    CubicWeights<P> weight[D];
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) weight[a] = CubicWeights<P>(s[a]);
    kernels::interpolate(
        weight, [&](int n) { return P::load_aligned(value_[n]); }, value, gradient);
  }

 private:
  bool has_left(int l) const {
    bool left = false;
    for (int a = 0; a < D; ++a) left |= base_[a][l] != cell_[a][l];
    return left;
  }

  void load_nodes(int l) {
    std::int64_t at = 0;
    bool inside = true;
    for (int a = D - 1; a >= 0; --a) {
      base_[a][l] = cell_[a][l];
      const auto first = static_cast<std::int64_t>(cell_[a][l]) - 1 - work_.lower[a];
      inside &= first >= 0 && first + 4 <= work_.extent[a];
      at = at * work_.extent[a] + first;
    }
    if (!inside) {
      for (auto& node : value_) node[l] = T(__builtin_nan(""));
      return;
    }
    for (int row = 0; row < power(4, D - 1); ++row) {
      const T* from = work_.values + at + work_.extent[0] * (row % 4);
      if constexpr (D == 3)
        from += static_cast<std::int64_t>(work_.extent[0]) * work_.extent[1] * (row / 4);
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i) value_[4 * row + i][l] = from[i];
    }
  }

  const ClosestPoints<T, D>& work_;
  alignas(64) T cell_[D][lanes<P>], base_[D][lanes<P>];
  alignas(64) T value_[power(4, D)][lanes<P>];
};

template <class P, int D>
inline P dot(const P (&x)[D], const P (&y)[D]) {
  P sum = x[0] * y[0];
#pragma GCC unroll 3
  for (int a = 1; a < D; ++a) sum = fused(x[a], y[a], sum);
  return sum;
}

/// Finds the points of nodes first..first+lanes-1. Lanes stop when they have converged or the
/// gradient vanishes.
template <class P, int D>
void find_closest_points_from(const ClosestPoints<Scalar<P>, D>& work, int first) {
  using T = Scalar<P>;
  NodesAround<P, D> nodes(work);
  P node[D], x[D], value, g[D];
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) {
    node[a] = load<P>(work.node[a] + first);
    x[a] = load<P>(work.point[a] + first);
  }
  auto active = x[0] == x[0];
  auto converged = !active;
  for (int iteration = 0; iteration < work.iterations && xsimd::any(active); ++iteration) {
    nodes.interpolate(x, value, g);
    const P square = dot<P, D>(g, g);
    active = active && square >= P(work.flattest);
    P back[D];
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) back[a] = node[a] - x[a];
    const P along = (value + dot<P, D>(back, g)) / square;
    P step[D];
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) step[a] = fused_minus(along, g[a], back[a]);
    const P length2 = dot<P, D>(step, step);
    const P scale = xsimd::select(length2 > P(T(0.25)), P(T(0.5)) / xsimd::sqrt(length2), P(T(1)));
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      x[a] = xsimd::select(active, fused(scale, step[a], x[a]), x[a]);
    }
    const auto arrived = active && length2 < P(work.shortest_step * work.shortest_step);
    converged = converged || arrived;
    active = active && !arrived;
  }
  if (xsimd::any(active)) {
    nodes.interpolate(x, value, g);
    converged = converged || (active && xsimd::abs(value) < P(work.smallest_value));
  }
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) x[a].store_unaligned(work.point[a] + first);
  xsimd::select(converged, P(T(1)), P(T(0))).store_unaligned(work.converged + first);
}

template <class P, int D>
void find_closest_points(const ClosestPoints<Scalar<P>, D>& work) {
  for (int first = 0; first < work.count; first += lanes<P>) {
    find_closest_points_from<P, D>(work, first);
  }
}

}  // namespace pliant::kernels
