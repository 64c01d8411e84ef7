#include "engine/point_based/bonds/node_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/method/decompositions.hpp"

namespace pliant::point_based {

namespace {

// Linear forces at rest: (PB.8) with P = lambda tr H I + mu (H + H^T). Groups are left out: they
// only soften, and cuts dissolve them.
template <class T, int D>
class SmallMotion {
  using Matrix = Eigen::Matrix<double, D, D>;
  using Vector = Eigen::Matrix<double, D, 1>;

 public:
  explicit SmallMotion(const Body<T, D>& body) : body_(body), pull_(body.slots) {}

  /// K u/m [slot]: minus the accelerations at small displacements u.
  const std::vector<Vector>& pull(const std::vector<Vector>& moved) {
    std::fill(pull_.begin(), pull_.end(), Vector::Zero());
    for (const NodeBlock& block : body_.blocks) {
      for (int i = 0; i < block.nodes; ++i) add_node(block, block.first + i, moved);
    }
    body_.for_each_node([&](std::int64_t slot) { pull_[slot] /= double{body_.mass[slot]}; });
    return pull_;
  }

 private:
  void add_node(const NodeBlock& block, std::int64_t slot, const std::vector<Vector>& moved) {
    const double volume = body_.volume[slot], stiffness = body_.stiffness[slot];
    Matrix h = Matrix::Zero(), moment;
    body_.for_each_bond(block, slot, [&](int, std::int64_t j, const Point<D>& g, double) {
      h += (moved[j] - moved[slot]) * Eigen::Map<const Vector>(g.data()).transpose();
    });
    for (int a = 0; a < D; ++a) {
      for (int b = 0; b < D; ++b) {
        moment(a, b) = body_.moment[kernels::symmetric_index<D>(a, b)][slot];
      }
    }
    const double mu = body_.material.shear_modulus, lambda = body_.material.lame_modulus;
    const Matrix piola = mu * (h + h.transpose()) + lambda * h.trace() * Matrix::Identity();
    const Matrix b = volume * piola - stiffness * h * moment;
    body_.for_each_bond(block, slot, [&](int, std::int64_t j, const Point<D>& g, double w) {
      const Vector force =
          b * Eigen::Map<const Vector>(g.data()) + stiffness * w * (moved[j] - moved[slot]);
      pull_[slot] -= force;
      pull_[j] += force;
    });
  }

  const Body<T, D>& body_;
  std::vector<Vector> pull_;
};

}  // namespace

// With the masses of the node and its neighbours, squared frequencies are the eigenvalues of H -> C
// : (H W), where C is that of the material. In the axes of W, diagonal H and each pair H_ij, H_ji
// decouple, and the largest eigenvalue belongs to diagonal H.
template <int D>
double node_frequency2(const NodeMaterial& node, std::span<const BondStiffness<D>> bonds) {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;
  Matrix w = Matrix::Zero();
  Vector own = Vector::Zero();
  double weights = 0, most = 0;
  for (const BondStiffness<D>& bond : bonds) {
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

template <class T, int D>
double joint_frequency_factor(const Body<T, D>& body) {
  constexpr int iterations = 40;
  SmallMotion<T, D> motion(body);
  std::vector<Eigen::Matrix<double, D, 1>> moved(body.slots, Eigen::Matrix<double, D, 1>::Zero());
  body.for_each_node([&](std::int64_t slot) {
    for (int a = 0; a < D; ++a) moved[slot][a] = std::sin(37. * slot + 5 * a);
  });
  double highest = 0, of_nodes = 0;  // squared frequencies
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const auto& pulled = motion.pull(moved);
    double square = 0, next = 0;
    body.for_each_node([&](std::int64_t slot) {
      const double mass = body.mass[slot];
      square += mass * moved[slot].squaredNorm();
      next += mass * pulled[slot].squaredNorm();
    });
    highest = std::sqrt(next / square);
    const double scale = 1 / std::sqrt(next);
    body.for_each_node([&](std::int64_t slot) { moved[slot] = scale * pulled[slot]; });
  }
  body.for_each_node(
      [&](std::int64_t slot) { of_nodes = std::max<double>(of_nodes, body.frequency2[slot]); });
  return std::max(1., highest / (energies_of_node * of_nodes));
}

template double node_frequency2<2>(const NodeMaterial&, std::span<const BondStiffness<2>>);
template double node_frequency2<3>(const NodeMaterial&, std::span<const BondStiffness<3>>);

template double joint_frequency_factor(const Body<double, 2>&);
template double joint_frequency_factor(const Body<double, 3>&);
template double joint_frequency_factor(const Body<float, 2>&);
template double joint_frequency_factor(const Body<float, 3>&);

}  // namespace pliant::point_based
