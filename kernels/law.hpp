#pragma once

#include "kernels/linear_elastic.hpp"
#include "kernels/reduced_polynomial.hpp"

namespace pliant::kernels {

/// Constitutive laws for the stages: the material state (S or F), its rate, and sigma = -p I + S of
/// (RP.2), p and c^2 of a state.
template <Model model, class P, int D>
struct Law {
  static constexpr int components = material_component_count<D>(model);
  static constexpr int symmetric = symmetric_components<D>;
  using Constants = Material<Scalar<P>>;

  static void rate(const Constants& material, const P (&s)[components], const P (&gradient)[D][D],
                   P (&result)[components]) {
    jaumann_rate<P, D>(P(material.shear_modulus), s, gradient, result);
  }

  static P pressure(const Constants& material, const P (&)[components], const P& density) {
    return linear_pressure<model>(P(material.bulk_modulus), density * P(1 / material.density));
  }

  static void stress(const Constants& material, const P (&s)[components], const P& density,
                     P (&sigma)[symmetric]) {
    const P p = pressure(material, s, density);
    for (int c = 0; c < symmetric; ++c) sigma[c] = s[c];
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      P& diagonal = sigma[symmetric_index<D>(i, i)];
      diagonal = diagonal - p;
    }
  }

  static P wave_speed2(const Constants& material, const P (&)[components], const P& density) {
    return linear_wave_speed2<model>(material, density);
  }
};

template <class P, int D>
struct Law<Model::reduced_polynomial, P, D> {
  static constexpr int components = material_component_count<D>(Model::reduced_polynomial);
  static constexpr int symmetric = symmetric_components<D>;
  using Constants = Material<Scalar<P>>;

  static void rate(const Constants&, const P (&f)[components], const P (&gradient)[D][D],
                   P (&result)[components]) {
    deformation_rate<P, D>(f, gradient, result);
  }

  static P pressure(const Constants& material, const P (&f)[components], const P&) {
    return polynomial_pressure(material, determinant(f));
  }

  static void stress(const Constants& material, const P (&f)[components], const P&,
                     P (&sigma)[symmetric]) {
    const IsochoricStrain<P, D> strain = isochoric_strain<P, D>(f);
    polynomial_deviator<P, D>(material, strain, sigma);
    const P p = polynomial_pressure(material, strain.volume_ratio);
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      P& diagonal = sigma[symmetric_index<D>(i, i)];
      diagonal = diagonal - p;
    }
  }

  static P wave_speed2(const Constants& material, const P (&f)[components], const P& density) {
    return polynomial_wave_speed2<P, D>(material, isochoric_strain<P, D>(f), density);
  }
};

}  // namespace pliant::kernels
