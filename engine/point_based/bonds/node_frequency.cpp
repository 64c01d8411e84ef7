#include "engine/point_based/bonds/node_frequency.hpp"

#include <algorithm>
#include <cmath>

#include "engine/method/decompositions.hpp"

namespace pliant::point_based {

// With the masses at the node and its neighbours, squared frequencies are the eigenvalues of
// H -> C : (H W), C of the material. In the axes of W, diagonal H and each pair H_ij, H_ji are
// apart from one another, and the largest eigenvalue is one of diagonal H.
template <int D>
double node_frequency2(const NodeMaterial& node, std::span<const SwingingBond<D>> bonds) {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;
  Matrix w = Matrix::Zero();
  Vector own = Vector::Zero();
  double weights = 0, most = 0;
  for (const SwingingBond<D>& bond : bonds) {
    const Eigen::Map<const Vector> g(bond.gradient.data());
    w += g * g.transpose() / bond.mass;
    own += g;
    weights += bond.weight;
    most = std::max(most, bond.weight / bond.mass);
  }
  w += own * own.transpose() / node.mass;
  const Vector along = node.volume * eigenvalues<D>(w).cwiseMax(0);
  const Vector root = along.cwiseSqrt();
  Matrix diagonal = node.lame_modulus * root * root.transpose();
  diagonal.diagonal() += 2 * node.shear_modulus * along;
  return eigenvalues<D>(diagonal)[D - 1] + node.stiffness * (weights / node.mass + most);
}

template double node_frequency2<2>(const NodeMaterial&, std::span<const SwingingBond<2>>);
template double node_frequency2<3>(const NodeMaterial&, std::span<const SwingingBond<3>>);

}  // namespace pliant::point_based
