#include "engine/point_based/node_state.hpp"

#include <cmath>

#include "engine/method/initial_stress.hpp"
#include "engine/point_based/degenerate_nodes.hpp"
#include "kernels/energy.hpp"
#include "kernels/point_based/first_piola.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::point_based {

namespace {

using Pack = xsimd::batch<double, xsimd::sse2>;
using Tensor = std::array<double, 9>;  // row by row

kernels::PointMaterial<double> in_double(const kernels::PointMaterial<double>& m) { return m; }
kernels::PointMaterial<double> in_double(const kernels::PointMaterial<float>& m) {
  return {m.law, m.density, m.shear_modulus, m.lame_modulus,
          kernels::with_scalar<double>(m.polynomial)};
}

template <kernels::ElasticLaw law>
Tensor piola_of(const kernels::PointMaterial<double>& material, const Tensor& f) {
  Pack packed[9], cof[9], p[9];
  for (int c = 0; c < 9; ++c) packed[c] = Pack(f[c]);
  kernels::cofactor(packed, cof);
  kernels::first_piola<law, Pack, 3>(material, packed, cof, p);
  Tensor result;
  for (int c = 0; c < 9; ++c) result[c] = p[c].get(0);
  return result;
}

Tensor piola(const kernels::PointMaterial<double>& material, const Tensor& f) {
  using enum kernels::ElasticLaw;
  switch (material.law) {
    case neo_hookean:
      return piola_of<neo_hookean>(material, f);
    case st_venant_kirchhoff:
      return piola_of<st_venant_kirchhoff>(material, f);
    default:
      return piola_of<reduced_polynomial>(material, f);
  }
}

double determinant(const Tensor& f) {
  return f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
         f[2] * (f[3] * f[7] - f[4] * f[6]);
}

/// psi of (PB.6), (PB.7), or (RP.63), per undeformed volume.
double energy_density(const kernels::PointMaterial<double>& material, const Tensor& f) {
  const double mu = material.shear_modulus, lambda = material.lame_modulus, j = determinant(f);
  if (material.law == kernels::ElasticLaw::reduced_polynomial) {
    return j * kernels::polynomial_energy<double, 3>(material.polynomial, f.data());
  }
  if (material.law == kernels::ElasticLaw::neo_hookean) {
    double square = 0;
    for (const double component : f) square += component * component;
    return mu / 2 * (square - 3) - mu * std::log(j) + lambda / 2 * (j - 1) * (j - 1);
  }
  double trace = 0, square = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      double c = i == k ? -1 : 0;
      for (int l = 0; l < 3; ++l) c += f[3 * l + i] * f[3 * l + k];
      square += c * c / 4;
      if (i == k) trace += c / 2;
    }
  }
  return lambda / 2 * trace * trace + mu * square;
}

/// With F_33 = 1 in plane strain.
template <int D>
Tensor in_3d(const std::array<double, D * D>& f) {
  Tensor full = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) full[3 * i + j] = f[D * i + j];
  }
  return full;
}

template <class T, int D>
LastingStress<D> lasting_stress(const Body<T, D>& body, std::int64_t slot,
                                const std::array<double, D * D>& f, double volume_ratio) {
  std::array<double, Body<T, D>::symmetric> stress;
  for (std::size_t c = 0; c < stress.size(); ++c) stress[c] = body.initial_stress[c][slot];
  return {stress, f, volume_ratio};
}

template <class T, int D>
const DegenerateNode<D>* degenerate_node(const Body<T, D>& body, const NodeBlock& block,
                                         std::int64_t slot) {
  for (const DegenerateNode<D>& node : body.degenerate[&block - body.blocks.data()]) {
    if (node.slot == slot) return &node;
  }
  return nullptr;
}

}  // namespace

template <class T, int D>
std::array<double, D * D> with_kept(const Body<T, D>& body, std::int64_t slot,
                                    const std::array<double, D * D>& fit) {
  if (!body.has_cuts()) return fit;
  std::array<double, D* D> f = {};
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      for (int k = 0; k < D; ++k) {
        f[D * i + j] += fit[D * i + k] * body.kept_gradient[D * k + j][slot];
      }
    }
  }
  return f;
}

template <class T, int D>
NodeFit<D> node_fit(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot) {
  std::array<double, D* D> h = {};
  double apart = 0;  // sum of w u_ij . u_ij
  body.for_each_bond(block, slot, [&](int, std::int64_t other, const Point<D>& g, double w) {
    for (int i = 0; i < D; ++i) {
      const double d =
          static_cast<double>(body.displacement[i][other]) - body.displacement[i][slot];
      apart += w * d * d;
      for (int j = 0; j < D; ++j) h[D * i + j] += d * g[j];
    }
  });
  NodeFit<D> found{h, 0};
  for (int i = 0; i < D; ++i) {
    found.gradient[D * i + i] += 1;
    for (int j = 0; j < D; ++j) {
      // The least-squares fit leaves this of it out: tr(H A H^T).
      for (int k = 0; k < D; ++k) {
        apart -= h[D * i + j] * h[D * i + k] * body.moment[kernels::symmetric_index<D>(j, k)][slot];
      }
    }
  }
  found.stabilisation = body.stiffness[slot] * apart / 2;
  return found;
}

template <class T, int D>
double strain_energy(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                     const std::array<double, D * D>& f) {
  const DegenerateNode<D>* const node = degenerate_node(body, block, slot);
  if (node != nullptr) return degenerate_state(body, block, *node).energy;
  double energy = strain_energy_density(body, f);
  if (body.is_prestressed()) energy += lasting_stress(body, slot, f, 1).energy;
  return body.volume[slot] * energy;
}

template <class T, int D>
NodeState<D> node_state(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot) {
  NodeState<D> state;
  const NodeFit<D> found = node_fit(body, block, slot);
  state.gradient = with_kept(body, slot, found.gradient);
  state.energy = found.stabilisation + strain_energy(body, block, slot, state.gradient);
  if (degenerate_node(body, block, slot) != nullptr) return state;
  const Tensor f = in_3d<D>(state.gradient);
  const auto material = in_double(body.material);
  const Tensor p = piola(material, f);
  const double jacobian = state.volume_ratio = determinant(f);
  double trace = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      double sigma = 0;
      for (int k = 0; k < 3; ++k) sigma += p[3 * i + k] * f[3 * j + k] / jacobian;
      if (i == j) trace += sigma;
      if (j < D) state.stress[kernels::symmetric_index<D>(i, j)] = sigma;
    }
  }
  state.pressure = -trace / 3;
  if (body.is_prestressed()) {
    const LastingStress<D> lasting = lasting_stress(body, slot, state.gradient, jacobian);
    for (std::size_t c = 0; c < state.stress.size(); ++c) state.stress[c] += lasting.stress[c];
    state.pressure += lasting.pressure(*body.source);
  }
  return state;
}

template <class T, int D>
std::array<double, D * D> fitted_gradient(const Body<T, D>& body, const NodeBlock& block,
                                          std::int64_t slot) {
  std::array<double, D* D> fit = {};
  for (int i = 0; i < D; ++i) fit[(D + 1) * i] = 1;
  body.for_each_bond(block, slot, [&](int, std::int64_t other, const Point<D>& g, double) {
    for (int i = 0; i < D; ++i) {
      const double d =
          static_cast<double>(body.displacement[i][other]) - body.displacement[i][slot];
      for (int j = 0; j < D; ++j) fit[D * i + j] += d * g[j];
    }
  });
  return fit;
}

template <class T, int D>
std::array<double, D * D> present_gradient(const Body<T, D>& body, const NodeBlock& block,
                                           std::int64_t slot) {
  return with_kept(body, slot, fitted_gradient(body, block, slot));
}

template <class T, int D>
double strain_energy_density(const Body<T, D>& body, const std::array<double, D * D>& f) {
  return energy_density(in_double(body.material), in_3d<D>(f));
}

template <class T, int D>
std::vector<Point<D>> present_corners(const Body<T, D>& body) {
  const BodySurface<D>& surface = body.surface;
  std::vector<Point<D>> place(surface.start.size());
  for (std::size_t c = 0; c < place.size(); ++c) {
    const std::int32_t slot = surface.node[c];
    Point<D> from;
    for (int a = 0; a < D; ++a) from[a] = surface.start[c][a] - body.start[slot][a];
    place[c] = body.position(slot);
    if (from == Point<D>{}) continue;
    const NodeState<D> node = node_state(body, body.block_of(slot), slot);
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) place[c][i] += node.gradient[D * i + j] * from[j];
    }
  }
  return place;
}

template NodeFit<2> node_fit(const Body<double, 2>&, const NodeBlock&, std::int64_t);
template std::array<double, 4> fitted_gradient(const Body<double, 2>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 4> with_kept(const Body<double, 2>&, std::int64_t,
                                         const std::array<double, 4>&);
template double strain_energy(const Body<double, 2>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 4>&);
template NodeFit<3> node_fit(const Body<double, 3>&, const NodeBlock&, std::int64_t);
template std::array<double, 9> fitted_gradient(const Body<double, 3>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 9> with_kept(const Body<double, 3>&, std::int64_t,
                                         const std::array<double, 9>&);
template double strain_energy(const Body<double, 3>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 9>&);
template NodeFit<2> node_fit(const Body<float, 2>&, const NodeBlock&, std::int64_t);
template std::array<double, 4> fitted_gradient(const Body<float, 2>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 4> with_kept(const Body<float, 2>&, std::int64_t,
                                         const std::array<double, 4>&);
template double strain_energy(const Body<float, 2>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 4>&);
template NodeFit<3> node_fit(const Body<float, 3>&, const NodeBlock&, std::int64_t);
template std::array<double, 9> fitted_gradient(const Body<float, 3>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 9> with_kept(const Body<float, 3>&, std::int64_t,
                                         const std::array<double, 9>&);
template double strain_energy(const Body<float, 3>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 9>&);
template std::array<double, 4> present_gradient(const Body<double, 2>&, const NodeBlock&,
                                                std::int64_t);
template std::array<double, 9> present_gradient(const Body<double, 3>&, const NodeBlock&,
                                                std::int64_t);
template std::array<double, 4> present_gradient(const Body<float, 2>&, const NodeBlock&,
                                                std::int64_t);
template std::array<double, 9> present_gradient(const Body<float, 3>&, const NodeBlock&,
                                                std::int64_t);
template std::vector<Point<2>> present_corners<double, 2>(const Body<double, 2>&);
template std::vector<Point<3>> present_corners<double, 3>(const Body<double, 3>&);
template std::vector<Point<2>> present_corners<float, 2>(const Body<float, 2>&);
template std::vector<Point<3>> present_corners<float, 3>(const Body<float, 3>&);
template double strain_energy_density<double, 2>(const Body<double, 2>&,
                                                 const std::array<double, 4>&);
template double strain_energy_density<double, 3>(const Body<double, 3>&,
                                                 const std::array<double, 9>&);
template double strain_energy_density<float, 2>(const Body<float, 2>&,
                                                const std::array<double, 4>&);
template double strain_energy_density<float, 3>(const Body<float, 3>&,
                                                const std::array<double, 9>&);
template NodeState<2> node_state(const Body<double, 2>&, const NodeBlock&, std::int64_t);
template NodeState<3> node_state(const Body<double, 3>&, const NodeBlock&, std::int64_t);
template NodeState<2> node_state(const Body<float, 2>&, const NodeBlock&, std::int64_t);
template NodeState<3> node_state(const Body<float, 3>&, const NodeBlock&, std::int64_t);

}  // namespace pliant::point_based
