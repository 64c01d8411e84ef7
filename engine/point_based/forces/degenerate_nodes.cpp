#include "engine/point_based/forces/degenerate_nodes.hpp"

#include "engine/method/hyperelastic.hpp"

namespace pliant::point_based {

namespace {

/// lambda of Hooke's law in `rank` of D directions that is free in the others: plane stress or a
/// bar in 3D, a bar in plane strain in 2D.
template <int D>
double reduced_lame_modulus(double mu, double lambda, int rank) {
  if (D - rank == 1) return 2 * lambda * mu / (lambda + 2 * mu);
  return mu * lambda / (lambda + mu);  // E - 2 mu
}

}  // namespace

template <class T, int D>
DegenerateState<D> degenerate_state(const Body<T, D>& body, const NodeBlock& block,
                                    const DegenerateNode<D>& node) {
  // [axis][direction]
  double f[D][D] = {};
  body.for_each_bond(block, node.slot, [&](int, std::int64_t other, const Point<D>& g, double) {
    const Point<D> from = body.position(node.slot), to = body.position(other);
    for (int r = 0; r < node.rank; ++r) {
      double along = 0;
      for (int a = 0; a < D; ++a) along += g[a] * node.direction[r][a];
      for (int a = 0; a < D; ++a) f[a][r] += (to[a] - from[a]) * along;
    }
  });
  double strain[D][D] = {}, trace = 0, square = 0;
  for (int r = 0; r < node.rank; ++r) {
    for (int s = 0; s < node.rank; ++s) {
      double c = r == s ? -1 : 0;
      for (int a = 0; a < D; ++a) c += f[a][r] * f[a][s];
      strain[r][s] = c / 2;
      square += c * c / 4;
      if (r == s) trace += c / 2;
    }
  }
  const double mu = long_term_share(body.prony_shear) * body.material.shear_modulus;
  const double lambda = reduced_lame_modulus<D>(mu, body.material.lame_modulus, node.rank);
  DegenerateState<D> state;
  state.energy = node.volume * (lambda / 2 * trace * trace + mu * square);
  for (int i = 0; i < D; ++i) {
    for (int r = 0; r < node.rank; ++r) {
      double p = 0;
      for (int s = 0; s < node.rank; ++s) {
        p += f[i][s] * (2 * mu * strain[s][r] + (r == s ? lambda * trace : 0));
      }
      for (int j = 0; j < D; ++j) {
        state.bond_stress[D * i + j] += node.volume * p * node.direction[r][j];
      }
    }
  }
  return state;
}

template <class T, int D>
void add_degenerate_forces(Body<T, D>& body, int b) {
  const NodeBlock& block = body.blocks[b];
  T* const force = body.force.get() + kernels::point_stride * block.first_point();
  for (const DegenerateNode<D>& node : body.degenerate[b]) {
    const auto stress = degenerate_state(body, block, node).bond_stress;
    const std::int64_t own = node.slot - block.first;
    body.for_each_bond(block, node.slot, [&](int k, std::int64_t, const Point<D>& g, double) {
      const std::int64_t other = body.local_neighbour(node.slot, k);
      for (int i = 0; i < D; ++i) {
        double t = 0;
        for (int j = 0; j < D; ++j) t += stress[D * i + j] * g[j];
        force[kernels::point_stride * own + i] += static_cast<T>(t);
        force[kernels::point_stride * other + i] -= static_cast<T>(t);
      }
    });
  }
}

template DegenerateState<2> degenerate_state(const Body<double, 2>&, const NodeBlock&,
                                             const DegenerateNode<2>&);
template DegenerateState<3> degenerate_state(const Body<double, 3>&, const NodeBlock&,
                                             const DegenerateNode<3>&);
template DegenerateState<2> degenerate_state(const Body<float, 2>&, const NodeBlock&,
                                             const DegenerateNode<2>&);
template DegenerateState<3> degenerate_state(const Body<float, 3>&, const NodeBlock&,
                                             const DegenerateNode<3>&);
template void add_degenerate_forces(Body<double, 2>&, int);
template void add_degenerate_forces(Body<double, 3>&, int);
template void add_degenerate_forces(Body<float, 2>&, int);
template void add_degenerate_forces(Body<float, 3>&, int);

}  // namespace pliant::point_based
