#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace pliant::kernels {

/// Constitutive law: (RP.3) with (RP.5) or (RP.6), (RP.9), (PB.6), or (PB.7).
enum class Model : std::uint8_t {
  linear,
  linear_logarithmic,
  reduced_polynomial,
  neo_hookean,
  st_venant_kirchhoff
};

/// Calls `f.operator()<model>()` with the model as a constant.
template <class F>
decltype(auto) with_model(Model model, F&& f) {
  switch (model) {
    case Model::linear:
      return f.template operator()<Model::linear>();
    case Model::linear_logarithmic:
      return f.template operator()<Model::linear_logarithmic>();
    case Model::neo_hookean:
      return f.template operator()<Model::neo_hookean>();
    case Model::st_venant_kirchhoff:
      return f.template operator()<Model::st_venant_kirchhoff>();
    case Model::reduced_polynomial:
      break;
  }
  return f.template operator()<Model::reduced_polynomial>();
}

/// Whether particles of a material carry F, not S.
constexpr bool carries_deformation(Model model) {
  return model != Model::linear && model != Model::linear_logarithmic;
}

/// Smoothing kernel of the moment-matrix gradient: (RP.15) to (RP.18).
enum class Kernel : std::uint8_t { quartic_spline, quartic_spline_fit, compact, fourth_order };

/// Slots on each side that a kernel reaches on an undeformed lattice: stencils are 5 x 5 or 3 x 3.
constexpr int stencil_reach(Kernel kernel) { return kernel == Kernel::compact ? 1 : 2; }

/// Ratio of the support radius to the spacing.
constexpr double support(Kernel kernel) { return kernel == Kernel::compact ? 1.75 : 2.5; }

/// Constants of one material, in SI units.
template <class T>
struct Material {
  Model model = Model::linear;
  T density = 1;  ///< rho0 [kg/m^3]
  T bulk_modulus =
      0;  ///< K = rho0 c0^2 [Pa], (RP.7); 2/D for the reduced polynomial, or K0 of (RP.10)
  T shear_modulus = 0;                ///< mu [Pa], (RP.7); 2 C10 for the reduced polynomial
  int order = 0;                      ///< N of (RP.9)
  std::array<T, 5> coefficient = {};  ///< C_n0 [Pa], n = 1..N
  T compressibility = 0;              ///< D [1/Pa]; 2/K0 with Prony terms
};

/// One term of the Prony series of the bulk modulus, (RP.10).
template <class T>
struct PronyTerm {
  T ratio;  ///< g_i
  T time;   ///< tau_i [s]
};

/// Speed of pressure waves in a material at rest [m/s], (RP.12).
template <class T>
T wave_speed_at_rest(const Material<T>& material) {
  return std::sqrt((material.bulk_modulus + material.shear_modulus * T(4) / T(3)) /
                   material.density);
}

/// Lame's first constant lambda [Pa].
template <class T>
T lame_modulus(const Material<T>& material) {
  return material.bulk_modulus - T(2) / T(3) * material.shear_modulus;
}

/// Components of S or F that a particle carries.
template <int D>
constexpr int material_component_count(Model model) {
  return carries_deformation(model) ? D * D : D * (D + 1) / 2;
}

}  // namespace pliant::kernels
