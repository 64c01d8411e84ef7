#pragma once

#include <cstdint>

#include "kernels/material.hpp"

namespace pliant::kernels {

/// Strain energy of the methods on the undeformed body: (PB.6), (PB.7), or (RP.9).
enum class ElasticLaw : std::uint8_t { neo_hookean, st_venant_kirchhoff, reduced_polynomial };

/// Constants of a material of the methods on the undeformed body.
template <class T>
struct HyperelasticMaterial {
  ElasticLaw law = ElasticLaw::neo_hookean;
  T density = 1;           ///< rho0 [kg/m^3]
  T shear_modulus = 0;     ///< mu [Pa]
  T lame_modulus = 0;      ///< lambda [Pa]
  Material<T> polynomial;  ///< for reduced polynomials; in (TL.3) also for linear materials
};

}  // namespace pliant::kernels
