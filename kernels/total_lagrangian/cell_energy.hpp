#pragma once

#include "kernels/cofactor.hpp"
#include "kernels/first_piola.hpp"
#include "kernels/stiffening.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

/// The strain energy of a cell, (TL.3) and (TL.6), or (TL.22), and its derivatives. They must be
/// inlined, since states must stay in registers. The constants of a linear material are those of
/// its hyperelastic form: N = 1, C10 = mu/2, 2/D = K.
namespace pliant::kernels {

/// dU/dJ of the volumetric part, (TL.3), from J and 1/J.
template <class P>
inline P volumetric_slope(const Material<Scalar<P>>& material, const P& volume_ratio,
                          const P& inverse_ratio) {
  using T = Scalar<P>;
  const P modulus(T(2) / material.compressibility), one(T(1));
  if (material.model == Model::linear) return modulus * (one - inverse_ratio);
  if (material.model == Model::linear_logarithmic) return modulus * logarithm(volume_ratio);
  return modulus * (volume_ratio - one);
}

/// J d^2U/dJ^2 of the volumetric part, (TL.3).
template <class P>
inline P volumetric_stiffness(const Material<Scalar<P>>& material, const P& volume_ratio) {
  using T = Scalar<P>;
  const P modulus(T(2) / material.compressibility);
  if (material.model == Model::linear) return modulus / volume_ratio;
  if (material.model == Model::linear_logarithmic) return modulus;
  return modulus * volume_ratio;
}

/// Arguments of the energy of a cell.
template <class P, int D>
struct CellState : Deformation<P, D> {
  P hourglass;    ///< Q of (TL.6)
  P by_f[D * D];  ///< half the derivative of F:F + Q with respect to F
};

/// Derivatives of the energy per undeformed volume of the cell.
template <class P, int D>
struct CellStress {
  P excess;  ///< I1* - 3 of (TL.3)
  P shear;  ///< factor from half the derivative of Q to the force of a mode [Pa]: 2 W1 J^(-2/3), or
            ///< mu
  P piola[D * D];  ///< P [Pa]
};

/// (TL.4) and (TL.6); `relaxed` is the sum of the p_i of (RP.10).
template <class P, int D>
[[gnu::always_inline]] inline CellStress<P, D> polynomial_stress(
    const Material<Scalar<P>>& material, const CellState<P, D>& state, const P& relaxed) {
  using T = Scalar<P>;
  CellStress<P, D> stress;
  P squares = D == 2 ? state.hourglass + P(T(1)) : state.hourglass;
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) squares = fused(state.f[c], state.f[c], squares);
  const P root = inverse_cube_root(state.volume_ratio);
  const P scale = root * root;
  stress.excess = fused(scale, squares, P(T(-3)));
  P first, second;
  energy_derivatives(material, stress.excess, first, second);
  stress.shear = (first + first) * scale;
  const P inverse_ratio = scale * root;  // 1/J without a division
  const P mean = stress.shear * squares * P(T(1) / T(3)) * inverse_ratio;
  const P spherical =
      volumetric_slope(material, state.volume_ratio, inverse_ratio) - relaxed - mean;
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) {
    stress.piola[c] = fused(stress.shear, state.by_f[c], spherical * state.cof[c]);
  }
  return stress;
}

/// (TL.22): the stress of the law; for hourglass modes, mu replaces 2 W1 J^(-2/3).
template <ElasticLaw law, class P, int D>
[[gnu::always_inline]] inline CellStress<P, D> law_stress(
    const HyperelasticMaterial<Scalar<P>>& material, const CellState<P, D>& state) {
  CellStress<P, D> stress;
  stress.excess = P(Scalar<P>(0));
  stress.shear = P(material.shear_modulus);
  first_piola<law, P, D>(material, state.f, state.cof, stress.piola);
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) {
    stress.piola[c] = fused(stress.shear, state.by_f[c] - state.f[c], stress.piola[c]);
  }
  return stress;
}

/// The stress of a cell by its law; `relaxed` is 0 for the laws of (TL.22).
template <ElasticLaw law, class P, int D>
[[gnu::always_inline]] inline CellStress<P, D> cell_stress(
    const HyperelasticMaterial<Scalar<P>>& material, const CellState<P, D>& state,
    const P& relaxed) {
  if constexpr (law == ElasticLaw::reduced_polynomial) {
    return polynomial_stress<P, D>(material.polynomial, state, relaxed);
  } else {
    return law_stress<law, P, D>(material, state);
  }
}

/// Upper bound of c^2, like (RP.12), with the I1* of the cell.
template <class P, int D>
inline P cell_wave_speed2(const Material<Scalar<P>>& material, const CellState<P, D>& state,
                          const P& excess) {
  using T = Scalar<P>;
  IsochoricStrain<P, D> strain = isochoric_strain<P, D>(state.f);
  strain.excess = excess;
  const P density = P(material.density) / state.volume_ratio;
  const P by_polynomial = P(T(2) / material.compressibility) * state.volume_ratio;
  return polynomial_wave_speed2<P, D>(material, strain, density) +
         (volumetric_stiffness(material, state.volume_ratio) - by_polynomial) / density;
}

}  // namespace pliant::kernels
