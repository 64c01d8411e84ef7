#include "engine/method/initial_stress.hpp"

namespace pliant {

double poissons_ratio(const BodyCase& body) {
  const double bulk = body.material.bulk_modulus, shear = body.material.shear_modulus;
  return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
}

std::array<double, 6> initial_stress(const BodyCase& body, const Vector& x, int dimension) {
  std::array<double, 6> stress = {};
  if (!body.stress) return stress;
  const auto at = [&x](const Expression& formula) { return formula(x[0], x[1], x[2], 0); };
  const auto put = [&stress](int i, int j, double value) {
    stress[kernels::symmetric_index<3>(i, j)] = value;
  };
  const double xx = at(body.stress->xx), yy = at(body.stress->yy);
  put(0, 0, xx);
  put(1, 1, yy);
  put(0, 1, at(body.stress->xy));
  if (dimension == 2) {
    put(2, 2, poissons_ratio(body) * (xx + yy));
    return stress;
  }
  put(2, 2, at(body.stress->zz));
  put(1, 2, at(body.stress->yz));
  put(0, 2, at(body.stress->xz));
  return stress;
}

}  // namespace pliant
