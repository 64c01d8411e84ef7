#pragma once

#include "kernels/cauchy_stress.hpp"
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

/// What laws of materials that carry F share.
template <class P, int D>
struct LawOfDeformation {
  static constexpr int components = D * D;
  static constexpr int symmetric = symmetric_components<D>;
  using Constants = Material<Scalar<P>>;

  static void rate(const Constants&, const P (&f)[components], const P (&gradient)[D][D],
                   P (&result)[components]) {
    deformation_rate<P, D>(f, gradient, result);
  }
};

template <class P, int D>
struct Law<Model::reduced_polynomial, P, D> : LawOfDeformation<P, D> {
  using Base = LawOfDeformation<P, D>;
  using Base::components, Base::symmetric;
  using typename Base::Constants;

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

/// Laws of which stress, pressure and wave speed follow from B and J.
template <auto stress_of, class P, int D>
struct LawOfStretch : LawOfDeformation<P, D> {
  using Base = LawOfDeformation<P, D>;
  using Base::components, Base::symmetric;
  using typename Base::Constants;

  static CauchyStress<P, D> cauchy_stress(const Constants& material, const P (&f)[components]) {
    P b[symmetric];
    left_cauchy_green<P, D>(f, b);
    return stress_of(material, determinant(f), b);
  }

  static P pressure(const Constants& material, const P (&f)[components], const P&) {
    return cauchy_stress(material, f).pressure();
  }

  static void stress(const Constants& material, const P (&f)[components], const P&,
                     P (&sigma)[symmetric]) {
    const CauchyStress<P, D> stress = cauchy_stress(material, f);
#pragma GCC unroll 6
    for (int c = 0; c < symmetric; ++c) sigma[c] = stress.sigma[c];
  }

  static P wave_speed2(const Constants& material, const P (&f)[components], const P& density) {
    return cauchy_stress(material, f).wave_modulus / density;
  }
};

template <class P, int D>
struct Law<Model::neo_hookean, P, D> : LawOfStretch<neo_hookean_stress<P, D>, P, D> {};

template <class P, int D>
struct Law<Model::st_venant_kirchhoff, P, D>
    : LawOfStretch<st_venant_kirchhoff_stress<P, D>, P, D> {};

}  // namespace pliant::kernels
