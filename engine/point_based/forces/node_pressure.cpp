#include "engine/point_based/forces/node_pressure.hpp"

#include <Eigen/Dense>

#include "engine/point_based/forces/node_gradient.hpp"

namespace pliant::point_based {

namespace {

template <int D>
auto matrix_of(const std::array<double, D * D>& f) {
  return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(f.data());
}

template <class T, int D>
bool counts_green_strain(const Body<T, D>& body) {
  return body.material.law == kernels::ElasticLaw::st_venant_kirchhoff;
}

}  // namespace

template <class T, int D>
double dilatation(const Body<T, D>& body, const std::array<double, D * D>& f) {
  if (!counts_green_strain(body)) return matrix_of<D>(f).determinant() - 1;
  return (matrix_of<D>(f).squaredNorm() - D) / 2;
}

template <class T, int D>
double mean_dilatation(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot) {
  const std::int64_t first = first_of_group<D>(slot);
  double mean = 0;
  for (std::int64_t s = first; s < first + kernels::slots_per_group<D>; ++s) {
    if (!(body.share[s] > 0)) continue;
    mean += body.share[s] * dilatation(body, fitted_gradient(body, block, s));
  }
  return mean;
}

template <class T, int D>
SharedPressure<D> shared_pressure(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                                  const std::array<double, D * D>& f) {
  SharedPressure<D> shared;
  if (!body.has_groups() || !(body.share[slot] > 0)) return shared;
  const double theta = dilatation(body, f), mean = mean_dilatation(body, block, slot);
  const double modulus = body.shared_modulus;
  shared.slope = modulus * (mean - theta);
  shared.energy = body.volume[slot] * modulus / 2 * (mean * mean - theta * theta);
  const double jacobian = matrix_of<D>(f).determinant();
  Eigen::Matrix<double, D, D> sigma = Eigen::Matrix<double, D, D>::Identity();
  double normal = 1;  // factor of the stress normal to the plane
  if (counts_green_strain(body)) {
    sigma = matrix_of<D>(f) * matrix_of<D>(f).transpose() / jacobian;
    normal = 1 / jacobian;
  }
  double trace = sigma.trace() + (D == 2 ? normal : 0);
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) {
      shared.stress[kernels::symmetric_index<D>(i, j)] = shared.slope * sigma(i, j);
    }
  }
  shared.pressure = -shared.slope * trace / 3;
  return shared;
}

template <class T, int D>
RelaxedPressure relaxed_pressure(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                                 const std::array<double, D * D>& f) {
  if (body.prony.empty()) return {};
  const bool shares = body.has_groups() && body.share[slot] > 0;
  const double theta = shares ? mean_dilatation(body, block, slot) : dilatation(body, f);
  const BulkHistory<T> history = {body.prony, body.memory_pressure, body.volume_change,
                                  body.material.polynomial.bulk_modulus, body.memory_age};
  return pliant::relaxed_pressure(history, slot, theta);
}

template SharedPressure<2> shared_pressure(const Body<double, 2>&, const NodeBlock&, std::int64_t,
                                           const std::array<double, 4>&);
template SharedPressure<3> shared_pressure(const Body<double, 3>&, const NodeBlock&, std::int64_t,
                                           const std::array<double, 9>&);
template SharedPressure<2> shared_pressure(const Body<float, 2>&, const NodeBlock&, std::int64_t,
                                           const std::array<double, 4>&);
template SharedPressure<3> shared_pressure(const Body<float, 3>&, const NodeBlock&, std::int64_t,
                                           const std::array<double, 9>&);
template double dilatation(const Body<double, 2>&, const std::array<double, 4>&);
template double mean_dilatation(const Body<double, 2>&, const NodeBlock&, std::int64_t);
template double dilatation(const Body<double, 3>&, const std::array<double, 9>&);
template double mean_dilatation(const Body<double, 3>&, const NodeBlock&, std::int64_t);
template double dilatation(const Body<float, 2>&, const std::array<double, 4>&);
template double mean_dilatation(const Body<float, 2>&, const NodeBlock&, std::int64_t);
template double dilatation(const Body<float, 3>&, const std::array<double, 9>&);
template double mean_dilatation(const Body<float, 3>&, const NodeBlock&, std::int64_t);
template RelaxedPressure relaxed_pressure(const Body<double, 2>&, const NodeBlock&, std::int64_t,
                                          const std::array<double, 4>&);
template RelaxedPressure relaxed_pressure(const Body<double, 3>&, const NodeBlock&, std::int64_t,
                                          const std::array<double, 9>&);
template RelaxedPressure relaxed_pressure(const Body<float, 2>&, const NodeBlock&, std::int64_t,
                                          const std::array<double, 4>&);
template RelaxedPressure relaxed_pressure(const Body<float, 3>&, const NodeBlock&, std::int64_t,
                                          const std::array<double, 9>&);

}  // namespace pliant::point_based
