#pragma once

#include "kernels/cofactor.hpp"
#include "kernels/reduced_polynomial.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"
#include "kernels/roots.hpp"

/// Networks of links that break and form anew, (TL.24): viscosity in shear of the methods on the
/// undeformed body.
namespace pliant::kernels {

/// F, cof F and J > 0 of a register of stress points.
template <class P, int D>
struct Deformation {
  P f[D * D], cof[D * D], volume_ratio;

  /// Computes the other members from `f`.
  void find_cofactor() {
    cofactor(f, cof);
    volume_ratio = f[0] * cof[0];
#pragma GCC unroll 3
    for (int j = 1; j < D; ++j) volume_ratio = fused(f[j], cof[j], volume_ratio);
  }
};

/// Components of the tensors of a network: xx, xy, yy, zz in plane strain, else symmetric_index.
template <int D>
inline constexpr int network_components = D == 2 ? 4 : 6;

/// The networks at the stress points of a body; a body without Prony terms of the shear modulus has
/// none.
template <class T>
struct Networks {
  int terms = 0;
  const Relaxation<T>* relaxation =
      nullptr;               ///< [term], since the last stress evaluation; for a modulus of 1
  const T* ratio = nullptr;  ///< [term] g_i over the share that does not relax
  /// [tensor * network_components + component][stress point] at the last stress: A_i - I for each
  /// term, then J^(2/3) C^-1 - I.
  const T* const* tensor = nullptr;
  T* const* next_tensor = nullptr;  ///< the same at this stress; may be the same arrays
};

/// One term, advanced by (RP.22).
template <class P>
inline P relax_term(const Relaxation<Scalar<P>>& term, const P& before, const P& start,
                    const P& end) {
  const P driven = fused(P(term.start), start, P(term.end) * end);
  return fused(P(term.decay), before, driven);
}

/// J^(2/3) C^-1 - I, with `scale` = J^(-2/3).
template <class P, int D>
inline void inverse_strain(const Deformation<P, D>& state, const P& scale,
                           P (&strain)[network_components<D>]) {
  const P factor = scale * scale, one(Scalar<P>(1));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      P sum = state.cof[i] * state.cof[j];
#pragma GCC unroll 3
      for (int k = 1; k < D; ++k) sum = fused(state.cof[D * k + i], state.cof[D * k + j], sum);
      strain[symmetric_index<D>(i, j)] = i == j ? factor * sum - one : factor * sum;
    }
  }
  if constexpr (D == 2) strain[3] = factor * state.volume_ratio * state.volume_ratio - one;
}

/// One network in its present state.
template <class P, int D>
struct Network {
  using T = Scalar<P>;
  P fa[D * D];  ///< F A
  P squares;    ///< C : A
  P across;     ///< A_zz in plane strain
  P scale;      ///< J^(-2/3)
  P excess;     ///< J^(-2/3) C : A - 3

  /// `a` is A - I.
  Network(const Deformation<P, D>& state, const P& isochoric, const P (&a)[network_components<D>])
      : scale(isochoric) {
    across = D == 2 ? a[network_components<D> - 1] + P(T(1)) : P(T(0));
    squares = across;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) {
        P sum = state.f[D * i + j];
#pragma GCC unroll 3
        for (int k = 0; k < D; ++k) {
          sum = fused(state.f[D * i + k], a[symmetric_index<D>(k, j)], sum);
        }
        fa[D * i + j] = sum;
        squares = fused(sum, state.f[D * i + j], squares);
      }
    }
    excess = fused(scale, squares, P(T(-3)));
  }

  /// Adds the stress of the network: `ratio` times that of `material` at I1* - 3 = excess.
  void add_stress(const Material<T>& material, T ratio, const Deformation<P, D>& state,
                  P (&piola)[D * D]) const {
    P first, second;
    energy_derivatives(material, excess, first, second);
    const P shear = P(2 * ratio) * first * scale;
    const P mean = shear * squares * P(T(1) / T(3)) / state.volume_ratio;
#pragma GCC unroll 9
    for (int c = 0; c < D * D; ++c) {
      piola[c] = fused_minus(mean, state.cof[c], fused(shear, fa[c], piola[c]));
    }
  }

  /// The contribution of the network to the bound of c^2, like (RP.12).
  P wave_speed2(const Material<T>& material, T ratio, const Deformation<P, D>& state) const {
    IsochoricStrain<P, D> strain;
    strain.volume_ratio = state.volume_ratio;
    strain.excess = excess;
    const P mean = (excess + P(T(3))) * P(T(1) / T(3));
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = i; j < D; ++j) {
        P b = fa[D * i] * state.f[D * j];
#pragma GCC unroll 3
        for (int k = 1; k < D; ++k) b = fused(fa[D * i + k], state.f[D * j + k], b);
        strain.deviator[symmetric_index<D>(i, j)] = i == j ? scale * b - mean : scale * b;
      }
    }
    strain.deviator_zz = scale * across - mean;
    const P density = P(material.density) / state.volume_ratio;
    const P by_volume = P(T(2) / material.compressibility) * state.volume_ratio / density;
    return P(ratio) * (polynomial_wave_speed2<P, D>(material, strain, density) - by_volume);
  }
};

/// Advances the networks of `material` to the present by (RP.22) and adds their stress to `piola`.
/// Returns their contribution to c^2; 0 unless `examine`. `Slots` reads and writes values of the
/// stress points.
template <class P, int D, class Slots>
inline P relax_networks(const Networks<Scalar<P>>& networks, const Material<Scalar<P>>& material,
                        bool examine, const Deformation<P, D>& state, const Slots& slots,
                        P (&piola)[D * D]) {
  using T = Scalar<P>;
  constexpr int components = network_components<D>;
  P speed2(T(0));
  const P root = inverse_cube_root(state.volume_ratio), scale = root * root;
  const int strain = networks.terms * components;
  P start[components], end[components];
  inverse_strain<P, D>(state, scale, end);
  for (int c = 0; c < components; ++c) {
    start[c] = slots.get(networks.tensor[strain + c]);
    slots.put(networks.next_tensor[strain + c], end[c], start[c]);
  }
  for (int i = 0; i < networks.terms; ++i) {
    P a[components];
    for (int c = 0; c < components; ++c) {
      const P before = slots.get(networks.tensor[i * components + c]);
      a[c] = relax_term(networks.relaxation[i], before, start[c], end[c]);
      slots.put(networks.next_tensor[i * components + c], a[c], before);
    }
    const Network<P, D> network(state, scale, a);
    network.add_stress(material, networks.ratio[i], state, piola);
    if (examine) speed2 = speed2 + network.wave_speed2(material, networks.ratio[i], state);
  }
  return speed2;
}

}  // namespace pliant::kernels
