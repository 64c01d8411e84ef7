#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/storage/buffer.hpp"
#include "kernels/networks.hpp"

/// The networks of (TL.24) in plain numbers, for measurements and output. Steps use the kernels.
namespace pliant {

/// The present stress of the networks of one stress point.
template <int D>
struct NetworkStress {
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< deviator of sigma [Pa]
  double energy = 0;                                                 ///< per undeformed volume [Pa]
};

/// Where the networks of a body were at its last stress.
template <class T>
struct NetworkHistory {
  const std::vector<kernels::PronyTerm<double>>& prony_shear;
  /// [tensor * network_components + component][stress point] as in kernels::Networks
  const std::vector<Buffer<T>>& tensor;
  double age;  ///< time since then [s]
};

/// The stress of the networks at the stress point `slot`, now that its deformation gradient is `f`
/// (F_33 = 1 in 2D). The coefficients of `material` are those of full relaxation.
template <class T, int D>
NetworkStress<D> network_stress(const kernels::Material<double>& material,
                                const NetworkHistory<T>& history, std::int64_t slot,
                                const Eigen::Matrix3d& f);

/// Adds `factor` times the deviator of the 3D tensor b to a symmetric tensor.
template <int D>
void add_deviator(double factor, const Eigen::Matrix3d& b,
                  std::array<double, kernels::symmetric_components<D>>& sum);

/// sum_n C_n0 (I1* - 3)^n
double polynomial_energy(const kernels::Material<double>& material, double excess);

}  // namespace pliant
