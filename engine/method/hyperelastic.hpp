#pragma once

#include <array>
#include <vector>

#include "engine/case/case.hpp"
#include "kernels/hyperelastic_material.hpp"
#include "kernels/layout.hpp"

/// Hyperelastic materials in plain numbers, for set-up and for measurements of the methods on the
/// undeformed body. Steps use the kernels.
namespace pliant {

/// The material of a body as kernels read it; a linear material as (PB.6), with the same constants.
kernels::HyperelasticMaterial<double> hyperelastic_material(const BodyCase& body);

/// The share of a modulus that remains when all terms of a Prony series have relaxed.
double long_term_share(const std::vector<kernels::PronyTerm<double>>& prony);

/// The stress at a deformation gradient; in 2D that of plane strain.
template <int D>
struct ElasticStress {
  double volume_ratio = 1;                                           ///< J
  double pressure = 0;                                               ///< [Pa]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< sigma [Pa]
};

/// (PB.6), (PB.7), or (RP.9) at the deformation gradient `f`, row by row.
template <int D>
ElasticStress<D> elastic_stress(const kernels::HyperelasticMaterial<double>& material,
                                const std::array<double, D * D>& f);

/// psi of (PB.6), (PB.7), or (RP.63) at the deformation gradient `f`, per undeformed volume [Pa].
template <int D>
double elastic_energy(const kernels::HyperelasticMaterial<double>& material,
                      const std::array<double, D * D>& f);

extern template ElasticStress<2> elastic_stress(const kernels::HyperelasticMaterial<double>&,
                                                const std::array<double, 4>&);
extern template ElasticStress<3> elastic_stress(const kernels::HyperelasticMaterial<double>&,
                                                const std::array<double, 9>&);
extern template double elastic_energy<2>(const kernels::HyperelasticMaterial<double>&,
                                         const std::array<double, 4>&);
extern template double elastic_energy<3>(const kernels::HyperelasticMaterial<double>&,
                                         const std::array<double, 9>&);

}  // namespace pliant
