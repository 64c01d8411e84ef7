#pragma once

#include "kernels/first_piola.hpp"
#include "kernels/left_cauchy_green.hpp"
#include "kernels/roots.hpp"

/// Bounds on how much stiffer a deformed material is to plane waves than at rest.
namespace pliant::kernels {

/// Upper bound of the square of the largest singular value.
template <class P, int D>
inline P norm2_of(const P (&f)[D * D]) {
  using T = Scalar<P>;
  P e[symmetric_components<D>];
  green_strain<P, D>(f, e);
  return fused(P(T(2)), eigenvalue_bound<P, D>(e), P(T(1)));
}

/// Upper bound of rho0 c_X^2 of (PB.12) at J > 0.
template <ElasticLaw law, class P, int D>
inline P wave_modulus(const HyperelasticMaterial<Scalar<P>>& material, const P (&f)[D * D]) {
  const P lambda(material.lame_modulus), mu(material.shear_modulus);
  P cof[D * D];
  cofactor(f, cof);
  const P jacobian = determinant(f);
  if constexpr (law == ElasticLaw::neo_hookean) {
    return fused(lambda + mu / (jacobian * jacobian), norm2_of<P, D>(cof), mu);
  } else if constexpr (law == ElasticLaw::st_venant_kirchhoff) {
    P e[symmetric_components<D>], s[symmetric_components<D>];
    green_strain<P, D>(f, e);
    hooke<P, D>(lambda, mu, e, s);
    return fused(lambda + mu + mu, norm2_of<P, D>(f), eigenvalue_bound<P, D>(s));
  } else {
    const P density = P(material.density) / jacobian;
    const P c2 = Law<Model::reduced_polynomial, P, D>::wave_speed2(material.polynomial, f, density);
    return P(material.density) * c2 * norm2_of<P, D>(cof) / (jacobian * jacobian);
  }
}

/// Upper bound of c_X^2/c^2 of (PB.12) at J > 0, at least 1; c is that of pressure waves at rest.
/// `added` is what more than the law adds to rho0 c_X^2.
template <ElasticLaw law, class P, int D>
inline P stiffening2(const HyperelasticMaterial<Scalar<P>>& material, const P (&f)[D * D],
                     const P& added = P(Scalar<P>(0))) {
  const P lambda(material.lame_modulus), mu(material.shear_modulus);
  const P modulus = wave_modulus<law, P, D>(material, f) + added;
  return xsimd::max(P(Scalar<P>(1)), modulus / (lambda + mu + mu));
}

}  // namespace pliant::kernels
