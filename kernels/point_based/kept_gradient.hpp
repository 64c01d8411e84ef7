#pragma once

#include "kernels/pack.hpp"
#include "kernels/point_based/arguments.hpp"

/// Deformation gradients of nodes, and those that nodes at cuts have kept, (PB.14).
namespace pliant::kernels {

/// F from `h`, F - I.
template <class P, int D>
[[gnu::always_inline]] inline void with_unit(const P (&h)[D * D], P (&f)[D * D]) {
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) f[c] = c % (D + 1) == 0 ? h[c] + P(Scalar<P>(1)) : h[c];
}

/// c += a b.
template <class P, int D>
inline void add_product(const P (&a)[D * D], const P (&b)[D * D], P (&c)[D * D]) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
#pragma GCC unroll 3
      for (int k = 0; k < D; ++k) c[D * i + j] = fused(a[D * i + k], b[D * k + j], c[D * i + j]);
    }
  }
}

/// Replaces F by F D of (PB.14), if nodes have kept gradients.
template <class P, int D>
inline void apply_kept(const PointForces<Scalar<P>, D>& block, std::int64_t slot, P (&f)[D * D],
                       P (&kept)[D * D]) {
  using T = Scalar<P>;
  P fit[D * D];
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) {
    kept[c] = load<P>(block.kept[c] + slot);
    fit[c] = f[c];
    f[c] = P(T(0));
  }
  add_product<P, D>(fit, kept, f);
}

}  // namespace pliant::kernels
