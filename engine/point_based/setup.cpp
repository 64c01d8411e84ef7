#include "engine/point_based/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/blocks/point_blocks.hpp"
#include "engine/boundaries/overhang.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/gravity.hpp"
#include "engine/method/hyperelastic.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/point_based/bonds/balance_bonds.hpp"
#include "engine/point_based/bonds/choose_neighbours.hpp"
#include "engine/point_based/bonds/chosen_bonds.hpp"
#include "engine/point_based/bonds/node_frequency.hpp"
#include "engine/point_based/bonds/patch_bonds.hpp"
#include "engine/point_based/forces/node_groups.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/surface/surface.hpp"
#include "engine/undeformed/network_memory.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::point_based {

namespace {

// Small blocks keep all workers busy; large ones have less halo per node.
constexpr int least_nodes_of_block = 512, most_nodes_of_block = 1536, least_blocks = 32;
constexpr double on_wall = 1e-9;

// The coefficients are those of full relaxation, (TL.24); the moduli are those of a sudden change.
template <class T, int D>
void take_material(const BodyCase& source, Body<T, D>& body) {
  kernels::HyperelasticMaterial<double> material = hyperelastic_material(source);
  const double lasting = long_term_share(source.prony_shear);
  for (double& coefficient : material.polynomial.coefficient) coefficient *= lasting;
  body.material = kernels::with_scalar<T>(material);
  body.prony = source.prony;
  body.memory_pressure.resize(body.prony.size());
  body.prony_shear = source.prony_shear;
  body.network.resize(undeformed::network_arrays<D>(body.prony_shear.size()));
}

template <class T, int D>
void lay_out(const NodeCloud<D>& cloud, Body<T, D>& body) {
  std::array<std::vector<double>, D> coordinate;
  std::array<std::span<const double>, D> view;
  for (int a = 0; a < D; ++a) {
    coordinate[a].reserve(cloud.positions.size());
    for (const Point<D>& x : cloud.positions) coordinate[a].push_back(x[a]);
    view[a] = coordinate[a];
  }
  // The adjacency of blocks follows later, from the bonds.
  body.particles = static_cast<std::int64_t>(cloud.positions.size());
  const auto nodes_of_block = static_cast<int>(std::clamp<std::int64_t>(
      body.particles / least_blocks, least_nodes_of_block, most_nodes_of_block));
  const PointBlocks points = blocks_of_points<double, D>(view, 0, nodes_of_block);
  for (std::size_t b = 0; b + 1 < points.first_slot.size(); ++b) {
    const std::int64_t begin = points.first_slot[b];
    const auto nodes = static_cast<int>(points.first_slot[b + 1] - begin);
    constexpr int lanes = kernels::slots_per_pack;
    const int count = (nodes + lanes - 1) / lanes * lanes;
    body.blocks.push_back({body.slots, count, nodes, 0, 0});
    for (int i = 0; i < count; ++i) {
      const std::int64_t node = i < nodes ? points.order[begin + i] : -1;
      body.number.push_back(node);
      body.start.push_back(cloud.positions[std::max<std::int64_t>(node, 0)]);
    }
    body.slots += count;
  }
}

bool has_resisted_cuts(const Case& settings, const BodyCase& source) {
  const auto body = &source - settings.bodies.data();
  return std::any_of(settings.cuts.begin(), settings.cuts.end(),
                     [body](const CutCase& cut) { return cut.body == body && cut.resists(); });
}

template <class T, int D>
void make_room(const Case& settings, const Boundaries<D>& boundaries, PressureForces pressures,
               Body<T, D>& body) {
  if (body.source->stress) body.initial_stress[0].grow(body.slots, T(0));
  if (parameters_of(settings).stiffness_damping > 0) body.strain[0].grow(body.slots, T(0));
  if (!parameters_of(settings).damping) body.sampled_force[0].grow(body.slots, T(0));
  for (const SurfacePressure<D>& load : boundaries.pressures) {
    const bool is_force = load.is_traction() || pressures == PressureForces::of_loads;
    (is_force ? body.traction : body.pressure_load)[0].grow(body.slots, T(0));
  }
  const Gravity<D> gravity(settings);
  if (gravity.acts() && !gravity.is_uniform()) body.traction[0].grow(body.slots, T(0));
  if (has_resisted_cuts(settings, *body.source)) {
    body.traction[0].grow(body.slots, T(0));
    body.bladed.resize(body.blocks.size());
  }
  if (has_cuts(settings, *body.source)) {
    for (int c = 0; c < D * D; ++c) {
      body.kept_gradient[c].grow(body.slots, c % (D + 1) == 0 ? T(1) : T(0));
    }
  }
  body.for_each_array([&](const Declaration&, auto components) {
    for (Buffer<T>& component : components) component.grow(body.slots, T(0));
  });
}

template <class T, int D>
void hold(const Boundaries<D>& boundaries, const std::vector<double>& reach_of_node,
          Body<T, D>& body) {
  const Shape& shape = body.source->geometry;
  const bool is_solid = !has_elements(shape);
  body.held.assign(body.blocks.size(), {});
  for (std::size_t b = 0; b < body.blocks.size(); ++b) {
    const NodeBlock& block = body.blocks[b];
    for (std::int64_t slot = block.first; slot < block.first + block.nodes; ++slot) {
      const Point<D>& x = body.start[slot];
      const double reach = reach_of_node[body.number[slot]];
      for (int w = 0; w < static_cast<int>(boundaries.walls.size()); ++w) {
        const Wall<D>& wall = boundaries.walls[w];
        const double distance = wall.distance(x), rounding = on_wall * body.resolution;
        if (!wall.is_attached() || distance >= reach - rounding) continue;
        if (is_solid && distance > rounding && is_beyond_rim<D>(shape, wall, x, reach)) continue;
        const auto place = static_cast<std::int32_t>(slot);
        body.held[b].push_back({place, w, wall.slips() ? wall.normal(x) : Point<D>{}, x});
      }
    }
  }
}

template <class T, int D>
void prestress(const BodyCase& source, Body<T, D>& body) {
  if (!body.is_prestressed()) return;
  body.for_each_node([&](std::int64_t slot) {
    const auto stress = initial_stress_in<D>(source, padded<D>(body.start[slot]));
    for (std::size_t c = 0; c < stress.size(); ++c) {
      body.initial_stress[c][slot] = static_cast<T>(stress[c]);
    }
  });
}

/// If all nodes of a lattice lie on the surface, they oscillate faster together than alone,
/// (PB.12).
template <int D>
bool has_two_layers(const Shape& shape, const Case& settings) {
  const Box<3> box = bounding_box(shape);
  for (int a = 0; a < D; ++a) {
    if (box.upper[a] - box.lower[a] < 1.5 * settings.discretisation.spacing) return true;
  }
  return false;
}

// Nodes that a wall holds start with the velocity of the wall.
template <class T, int D>
void set_in_motion(const BodyCase& source, const Boundaries<D>& boundaries, Body<T, D>& body) {
  body.for_each_node([&](std::int64_t slot) {
    const Vector u = initial_velocity(source, padded<D>(body.start[slot]));
    for (int a = 0; a < D; ++a) body.velocity[a][slot] = static_cast<T>(u[a]);
  });
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& held : of_block) {
      if (held.normal != Point<D>{}) continue;
      const Point<D> u = boundaries.walls[held.wall].motion(0).of(held.start);
      for (int a = 0; a < D; ++a) body.velocity[a][held.slot] = static_cast<T>(u[a]);
    }
  }
}

}  // namespace

template <class T, int D>
void make_nodes(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                const Boundaries<D>& boundaries, PressureForces pressures, Body<T, D>& body) {
  body.name = source.name;
  body.source = &source;
  take_material(source, body);
  lay_out(nodes.cloud, body);
  make_room(settings, boundaries, pressures, body);
  body.resolution = std::numeric_limits<double>::infinity();
  body.for_each_node([&](std::int64_t slot) {
    const double volume = nodes.cloud.volumes[body.number[slot]];
    body.volume_at_rest += volume;
    body.resolution = std::min(body.resolution, std::pow(volume, 1. / D));
    body.volume[slot] = static_cast<T>(volume);
    body.mass[slot] = static_cast<T>(source.material.density * volume);
    body.inverse_mass[slot] = static_cast<T>(1 / (source.material.density * volume));
  });
  hold(boundaries, nodes.reach, body);
  make_surface(nodes.cloud, source.geometry, settings.discretisation.spacing, boundaries, body);
  set_in_motion(source, boundaries, body);
  prestress(source, body);
}

template <class T, int D>
BondChoice<D> make_body(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                        const Boundaries<D>& boundaries, scheduler::Workers& workers,
                        Body<T, D>& body) {
  make_nodes(settings, source, nodes, boundaries, PressureForces::of_bonds, body);
  BondChoice<D> choice = choose_neighbours(settings, nodes, body, workers);
  if (nodes.cloud.elements.empty() && !body.has_cuts()) {
    fit_surface(ChosenBonds<D>(nodes.cloud, choice), choice.slot_of, body);
  }
  if (parameters_of(settings).gradient == NodeGradient::patch_exact) {
    correct_weights(nodes.cloud, body, choice, workers);
  } else if (!nodes.cloud.is_regular || choice.neighbours != nodes_around(D)) {
    balance_bonds(nodes.cloud, body, boundaries, choice, workers);
  }
  make_bonds(choice, body);
  form_groups(choice.is_lattice(), body);
  if (!choice.is_lattice() || has_two_layers<D>(source.geometry, settings)) {
    choice.joint_frequency_factor = joint_frequency_factor(body);
    body.for_each_node([&](std::int64_t slot) {
      body.frequency2[slot] *= static_cast<T>(choice.joint_frequency_factor);
    });
  }
  make_loads(boundaries, body);
  return choice;
}

template <class T, int D>
scheduler::Blocks number_blocks(State<T, D>& state) {
  std::vector<scheduler::Blocks> blocks;
  blocks.reserve(state.bodies.size());
  for (const Body<T, D>& body : state.bodies) {
    pliant::number_blocks(static_cast<int>(blocks.size()), body.adjacency.count(), state.blocks);
    blocks.push_back(body.adjacency);
  }
  return join_blocks(blocks);
}

template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<2>&, const Boundaries<2>&,
                         PressureForces, Body<double, 2>&);
template BondChoice<2> make_body<double, 2>(const Case&, const BodyCase&, const PlacedNodes<2>&,
                                            const Boundaries<2>&, scheduler::Workers&,
                                            Body<double, 2>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<3>&, const Boundaries<3>&,
                         PressureForces, Body<double, 3>&);
template BondChoice<3> make_body<double, 3>(const Case&, const BodyCase&, const PlacedNodes<3>&,
                                            const Boundaries<3>&, scheduler::Workers&,
                                            Body<double, 3>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<2>&, const Boundaries<2>&,
                         PressureForces, Body<float, 2>&);
template BondChoice<2> make_body<float, 2>(const Case&, const BodyCase&, const PlacedNodes<2>&,
                                           const Boundaries<2>&, scheduler::Workers&,
                                           Body<float, 2>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<3>&, const Boundaries<3>&,
                         PressureForces, Body<float, 3>&);
template BondChoice<3> make_body<float, 3>(const Case&, const BodyCase&, const PlacedNodes<3>&,
                                           const Boundaries<3>&, scheduler::Workers&,
                                           Body<float, 3>&);
template scheduler::Blocks number_blocks(State<double, 2>&);
template scheduler::Blocks number_blocks(State<double, 3>&);
template scheduler::Blocks number_blocks(State<float, 2>&);
template scheduler::Blocks number_blocks(State<float, 3>&);

}  // namespace pliant::point_based
