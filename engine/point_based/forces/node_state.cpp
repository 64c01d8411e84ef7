#include "engine/point_based/forces/node_state.hpp"

#include <Eigen/Dense>

#include "engine/method/hyperelastic.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/networks.hpp"
#include "engine/point_based/forces/degenerate_nodes.hpp"
#include "engine/point_based/forces/node_gradient.hpp"
#include "engine/point_based/forces/node_pressure.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::point_based {

namespace {

template <class T, int D>
ConstantStress<D> lasting_stress(const Body<T, D>& body, std::int64_t slot,
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

/// The stress of the networks of a node, (TL.24).
template <class T, int D>
NetworkStress<D> networks_at(const Body<T, D>& body, std::int64_t slot,
                             const std::array<double, D * D>& f) {
  if (body.network.empty()) return {};
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.topLeftCorner<D, D>() =
      Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(f.data());
  return network_stress<T, D>(kernels::with_scalar<double>(body.material).polynomial,
                              {body.prony_shear, body.network, body.memory_age}, slot, full);
}

}  // namespace

template <class T, int D>
double strain_energy(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                     const std::array<double, D * D>& f) {
  const DegenerateNode<D>* const node = degenerate_node(body, block, slot);
  if (node != nullptr) return degenerate_state(body, block, *node).energy;
  double energy = strain_energy_density(body, f) + networks_at(body, slot, f).energy +
                  relaxed_pressure(body, block, slot, f).energy;
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
  const ElasticStress<D> elastic =
      elastic_stress<D>(kernels::with_scalar<double>(body.material), state.gradient);
  state.volume_ratio = elastic.volume_ratio;
  state.stress = elastic.stress;
  state.pressure = elastic.pressure;
  const SharedPressure<D> shared = shared_pressure(body, block, slot, state.gradient);
  state.energy += shared.energy;
  const RelaxedPressure relaxed = relaxed_pressure(body, block, slot, state.gradient);
  state.pressure += shared.pressure + relaxed.pressure;
  for (int a = 0; a < D; ++a) {
    state.stress[kernels::symmetric_index<D>(a, a)] -= relaxed.pressure;
  }
  const NetworkStress<D> networks = networks_at(body, slot, state.gradient);
  for (std::size_t c = 0; c < state.stress.size(); ++c) {
    state.stress[c] += shared.stress[c] + networks.stress[c];
  }
  if (body.is_prestressed()) {
    const ConstantStress<D> lasting =
        lasting_stress(body, slot, state.gradient, state.volume_ratio);
    for (std::size_t c = 0; c < state.stress.size(); ++c) state.stress[c] += lasting.stress[c];
    state.pressure += lasting.pressure(*body.source);
  }
  return state;
}

template <class T, int D>
double strain_energy_density(const Body<T, D>& body, const std::array<double, D * D>& f) {
  return elastic_energy<D>(kernels::with_scalar<double>(body.material), f);
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

template double strain_energy(const Body<double, 2>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 4>&);
template double strain_energy(const Body<double, 3>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 9>&);
template double strain_energy(const Body<float, 2>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 4>&);
template double strain_energy(const Body<float, 3>&, const NodeBlock&, std::int64_t,
                              const std::array<double, 9>&);
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
