#include "engine/case/elastic_constants.hpp"

#include <algorithm>

namespace pliant {

kernels::Material<double> elastic_constants(const MaterialCase& given) {
  kernels::Material<double> material;
  material.density = given.density;
  if (given.model == MaterialCase::Model::linear) {
    material.model = given.law == MaterialCase::Law::rho ? kernels::Model::linear_rho
                                                         : kernels::Model::linear_log;
    // (RP.7)
    material.bulk_modulus = given.youngs_modulus / (3 * (1 - 2 * given.poissons_ratio));
    material.shear_modulus = given.youngs_modulus / (2 * (1 + given.poissons_ratio));
  } else {
    material.model = kernels::Model::reduced_polynomial;
    material.order = static_cast<int>(given.coefficients.size());
    std::copy(given.coefficients.begin(), given.coefficients.end(), material.coefficient.begin());
    material.compressibility = given.compressibility;
    material.bulk_modulus = 2 / given.compressibility;
    material.shear_modulus = 2 * given.coefficients.front();
  }
  return material;
}

}  // namespace pliant
