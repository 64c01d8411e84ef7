#include "engine/case/elastic_constants.hpp"

#include <algorithm>
#include <numeric>

namespace pliant {

kernels::Material<double> elastic_constants(const MaterialCase& given) {
  kernels::Material<double> material;
  material.density = given.density;
  if (given.model != MaterialCase::Model::reduced_polynomial) {
    material.model = given.equation_of_state == MaterialCase::EquationOfState::linear
                         ? kernels::Model::linear
                         : kernels::Model::linear_logarithmic;
    // (RP.7)
    material.bulk_modulus = given.youngs_modulus / (3 * (1 - 2 * given.poissons_ratio));
    material.shear_modulus = given.youngs_modulus / (2 * (1 + given.poissons_ratio));
  } else {
    material.model = kernels::Model::reduced_polynomial;
    material.order = static_cast<int>(given.coefficients.size());
    std::copy(given.coefficients.begin(), given.coefficients.end(), material.coefficient.begin());
    const PronyCase& prony = given.prony;
    const double relaxing = std::accumulate(prony.ratios.begin(), prony.ratios.end(), 0.0);
    const double left = prony.moduli == PronyCase::Moduli::long_term ? 1 - relaxing : 1;
    material.compressibility = given.compressibility * left;
    material.bulk_modulus = 2 / material.compressibility;
    material.shear_modulus = 2 * given.coefficients.front();
  }
  return material;
}

std::vector<kernels::PronyTerm<double>> prony_terms(const MaterialCase& given) {
  std::vector<kernels::PronyTerm<double>> terms;
  for (std::size_t i = 0; i < given.prony.ratios.size(); ++i) {
    terms.push_back({given.prony.ratios[i], given.prony.times[i]});
  }
  return terms;
}

}  // namespace pliant
