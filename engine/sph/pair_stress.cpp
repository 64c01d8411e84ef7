#include "engine/sph/pair_stress.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace pliant::sph {

template <class T, int D>
void find_pair_stress(const remeshed::Body<T, D>& body, int block, int stage,
                      double artificial_stress, PairStress<T, D>& pair_stress) {
  using Matrix = Eigen::Matrix<T, D, D>;
  const Layout<D>& layout = body.population.layout;
  const auto stress = body.stress_view(stage % 2);
  const T* mass = body.stage[0].get(remeshed::Field::mass);
  const T* volume = body.stage[remeshed::buffer_of(stage)].get(remeshed::Field::volume);
  Eigen::SelfAdjointEigenSolver<Matrix> principal;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>&) {
    if (body.population.kind[p] != kernels::Kind::interior) return;
    const T density = mass[p] / volume[p];
    Matrix scaled;
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        scaled(i, j) = stress[kernels::symmetric_index<D>(i, j)][p] / (density * density);
      }
    }
    principal.computeDirect(scaled);
    const auto& axes = principal.eigenvectors();
    const auto tension = principal.eigenvalues().cwiseMax(T(0));
    const Matrix artificial =
        static_cast<T>(-artificial_stress) * axes * tension.asDiagonal() * axes.transpose();
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        const int c = kernels::symmetric_index<D>(i, j);
        pair_stress.scaled[c][p] = scaled(i, j);
        pair_stress.artificial[c][p] = artificial(i, j);
      }
    }
  });
}

template void find_pair_stress<double, 2>(const remeshed::Body<double, 2>&, int, int, double,
                                          PairStress<double, 2>&);
template void find_pair_stress<double, 3>(const remeshed::Body<double, 3>&, int, int, double,
                                          PairStress<double, 3>&);
template void find_pair_stress<float, 2>(const remeshed::Body<float, 2>&, int, int, double,
                                         PairStress<float, 2>&);
template void find_pair_stress<float, 3>(const remeshed::Body<float, 3>&, int, int, double,
                                         PairStress<float, 3>&);

}  // namespace pliant::sph
