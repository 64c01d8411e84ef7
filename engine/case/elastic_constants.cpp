#include "engine/case/elastic_constants.hpp"

#include <algorithm>
#include <numeric>

namespace pliant {

namespace {

/// Ratio of the modulus of the case to that of a sudden change.
double share_of(const PronyCase& prony) {
  if (prony.moduli == PronyCase::Moduli::instantaneous) return 1;
  return 1 - std::accumulate(prony.ratios.begin(), prony.ratios.end(), 0.0);
}

kernels::Model model_of(const MaterialCase& given) {
  switch (given.model) {
    case MaterialCase::Model::reduced_polynomial:
      return kernels::Model::reduced_polynomial;
    case MaterialCase::Model::neo_hookean:
      return kernels::Model::neo_hookean;
    case MaterialCase::Model::st_venant_kirchhoff:
      return kernels::Model::st_venant_kirchhoff;
    case MaterialCase::Model::linear:
      break;
  }
  return given.equation_of_state == MaterialCase::EquationOfState::linear
             ? kernels::Model::linear
             : kernels::Model::linear_logarithmic;
}

}  // namespace

kernels::Material<double> elastic_constants(const MaterialCase& given) {
  kernels::Material<double> material;
  material.model = model_of(given);
  material.density = given.density;
  if (given.model != MaterialCase::Model::reduced_polynomial) {
    // (RP.7)
    material.bulk_modulus = given.youngs_modulus / (3 * (1 - 2 * given.poissons_ratio));
    material.shear_modulus = given.youngs_modulus / (2 * (1 + given.poissons_ratio));
  } else {
    material.order = static_cast<int>(given.coefficients.size());
    std::copy(given.coefficients.begin(), given.coefficients.end(), material.coefficient.begin());
    for (double& coefficient : material.coefficient) coefficient /= share_of(given.prony_shear);
    material.compressibility = given.compressibility * share_of(given.prony);
    material.bulk_modulus = 2 / material.compressibility;
    material.shear_modulus = 2 * material.coefficient.front();
  }
  return material;
}

std::vector<kernels::PronyTerm<double>> prony_terms(const PronyCase& given) {
  std::vector<kernels::PronyTerm<double>> terms;
  for (std::size_t i = 0; i < given.ratios.size(); ++i) {
    terms.push_back({given.ratios[i], given.times[i]});
  }
  return terms;
}

}  // namespace pliant
