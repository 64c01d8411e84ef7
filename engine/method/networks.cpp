#include "engine/method/networks.hpp"

#include <cmath>

#include "engine/method/hyperelastic.hpp"

namespace pliant {

namespace {

using Pack = xsimd::batch<double, xsimd::sse2>;

/// The tensor of a stress point that begins at array `first`.
template <class T, int D>
Eigen::Matrix3d tensor_at(const std::vector<Buffer<T>>& arrays, std::size_t first,
                          std::int64_t slot) {
  Eigen::Matrix3d full = Eigen::Matrix3d::Zero();
  for (int k = 0; k < D; ++k) {
    for (int l = 0; l < D; ++l) {
      full(k, l) = arrays[first + kernels::symmetric_index<D>(k, l)][slot];
    }
  }
  if (D == 2) full(2, 2) = arrays[first + kernels::network_components<D> - 1][slot];
  return full;
}

}  // namespace

template <class T, int D>
NetworkStress<D> network_stress(const kernels::Material<double>& material,
                                const NetworkHistory<T>& history, std::int64_t slot,
                                const Eigen::Matrix3d& f) {
  constexpr std::size_t components = kernels::network_components<D>;
  const auto& terms = history.prony_shear;
  const double j = f.determinant(), scale = std::pow(j, -2. / 3);
  const Eigen::Matrix3d strain =
      (f.transpose() * f).inverse() / scale - Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d before = tensor_at<T, D>(history.tensor, components * terms.size(), slot);
  const double lasting = long_term_share(terms);
  NetworkStress<D> sum;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto term = kernels::relaxation<double>({1, terms[i].time}, 1, history.age);
    const Eigen::Matrix3d a = Eigen::Matrix3d::Identity() +
                              term.decay * tensor_at<T, D>(history.tensor, components * i, slot) +
                              term.start * before + term.end * strain;
    const Eigen::Matrix3d b = scale * f * a * f.transpose();
    const double excess = b.trace() - 3, ratio = terms[i].ratio / lasting;
    Pack first, second;
    kernels::energy_derivatives(material, Pack(excess), first, second);
    add_deviator<D>(2 * ratio * first.get(0) / j, b, sum.stress);
    sum.energy += ratio * polynomial_energy(material, excess);
  }
  return sum;
}

template <int D>
void add_deviator(double factor, const Eigen::Matrix3d& b,
                  std::array<double, kernels::symmetric_components<D>>& sum) {
  const double mean = b.trace() / 3;
  for (int i = 0; i < D; ++i) {
    for (int k = i; k < D; ++k) {
      sum[kernels::symmetric_index<D>(i, k)] += factor * (b(i, k) - (i == k ? mean : 0));
    }
  }
}

double polynomial_energy(const kernels::Material<double>& material, double excess) {
  double energy = 0, power = 1;
  for (int n = 1; n <= material.order; ++n) {
    power *= excess;
    energy += material.coefficient[n - 1] * power;
  }
  return energy;
}

template NetworkStress<2> network_stress<double, 2>(const kernels::Material<double>&,
                                                    const NetworkHistory<double>&, std::int64_t,
                                                    const Eigen::Matrix3d&);
template NetworkStress<3> network_stress<double, 3>(const kernels::Material<double>&,
                                                    const NetworkHistory<double>&, std::int64_t,
                                                    const Eigen::Matrix3d&);
template NetworkStress<2> network_stress<float, 2>(const kernels::Material<double>&,
                                                   const NetworkHistory<float>&, std::int64_t,
                                                   const Eigen::Matrix3d&);
template NetworkStress<3> network_stress<float, 3>(const kernels::Material<double>&,
                                                   const NetworkHistory<float>&, std::int64_t,
                                                   const Eigen::Matrix3d&);
template void add_deviator<2>(double, const Eigen::Matrix3d&, std::array<double, 3>&);
template void add_deviator<3>(double, const Eigen::Matrix3d&, std::array<double, 6>&);

}  // namespace pliant
