#include "engine/remeshed/loads/shear_stress.hpp"

#include <cmath>

namespace pliant::remeshed {

template <class T, int D>
void take_shear_stress(Body<T, D>& body, int block, int stage) {
  const auto stress = body.stress_view(stage % 2);
  const double volume = std::pow(body.lattice.spacing, D);
  BlockShear<D>& shear = body.shear[block];
  for (std::size_t k = 0; k < shear.own.size(); ++k) {
    const auto [other, number] = shear.own[k];
    const ShearShare<D>& share = body.shear[other].shares[number];
    const ShearPatch<D>& patch = body.shear[other].patches[share.patch];
    const Point<D>& n = patch.axes[0];
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        const int c = kernels::symmetric_index<D>(i, j);
        T& component = stress[c][share.slot];
        shear.before[k][c] = component;
        const double along = patch.mean[i] * n[j] + patch.mean[j] * n[i];
        component -= static_cast<T>(share.stress_weight * along / volume);
      }
    }
  }
}

// A particle may have several shares: the first of them has the stress before all.
template <class T, int D>
void give_back_shear_stress(Body<T, D>& body, int block) {
  const auto stress = body.stress_view(0);
  const BlockShear<D>& shear = body.shear[block];
  for (std::size_t k = shear.own.size(); k-- > 0;) {
    const auto [other, number] = shear.own[k];
    const std::int32_t slot = body.shear[other].shares[number].slot;
    for (std::size_t c = 0; c < stress.size(); ++c) {
      stress[c][slot] = static_cast<T>(shear.before[k][c]);
    }
  }
}

template void take_shear_stress<double, 2>(Body<double, 2>&, int, int);
template void give_back_shear_stress<double, 2>(Body<double, 2>&, int);
template void take_shear_stress<double, 3>(Body<double, 3>&, int, int);
template void give_back_shear_stress<double, 3>(Body<double, 3>&, int);
template void take_shear_stress<float, 2>(Body<float, 2>&, int, int);
template void give_back_shear_stress<float, 2>(Body<float, 2>&, int);
template void take_shear_stress<float, 3>(Body<float, 3>&, int, int);
template void give_back_shear_stress<float, 3>(Body<float, 3>&, int);

}  // namespace pliant::remeshed
