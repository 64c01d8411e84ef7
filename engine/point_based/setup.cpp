#include "engine/point_based/setup.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/blocks/point_blocks.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/gravity.hpp"
#include "engine/method/hyperelastic.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/point_based/bonds/candidates.hpp"
#include "engine/point_based/bonds/node_frequency.hpp"
#include "engine/point_based/bonds/patch_bonds.hpp"
#include "engine/point_based/forces/node_groups.hpp"
#include "engine/point_based/nodes/body_lattice.hpp"
#include "engine/point_based/nodes/cut_places.hpp"
#include "engine/point_based/nodes/lattice_nodes.hpp"
#include "engine/point_based/nodes/mesh_nodes.hpp"
#include "engine/point_based/nodes/nodes_at_walls.hpp"
#include "engine/point_based/nodes/octree_nodes.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/surface/surface.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::point_based {

namespace {

// Small blocks keep all workers busy; large ones have less halo per node.
constexpr int least_nodes_of_block = 512, most_nodes_of_block = 1536, least_blocks = 32;
constexpr double on_wall = 1e-9;

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

// Irregular nodes replace neighbours that cuts remove by nodes farther away.
template <class T, int D>
BondChoice<D> choice_of(const Case& settings, const PlacedNodes<D>& nodes, const Body<T, D>& body) {
  constexpr int candidates_per_neighbour = 3;
  constexpr int searched = 3;  // nodes more for each neighbour, of which some are too small
  BondChoice<D> choice;
  choice.neighbours = neighbour_count(settings);
  choice.support = nodes.support;
  choice.alpha = parameters_of(settings).stabilisation.value_or(nodes.alpha);
  choice.may_change = has_cuts(settings, *body.source);
  const bool is_lattice = !std::isinf(nodes.support);
  const int ranks = !is_lattice && choice.may_change ? candidates_per_neighbour : 1;
  // The patch test balances the forces on the whole body, including those that walls take.
  choice.elastic_volumes = parameters_of(settings).gradient == NodeGradient::patch_exact
                               ? nodes.cloud.volumes
                               : nodes.elastic_volumes;
  const int candidates = ranks * choice.neighbours + 1;
  choice.candidates = find_candidates<D>(
      nodes.stretched(), choice.elastic_volumes,
      is_lattice ? candidates : candidates + searched * choice.neighbours, body.name);
  if (!is_lattice) sort_by_size<D>(candidates, choice.candidates);
  for (auto& list : choice.candidates) {
    const auto most = static_cast<std::size_t>(choice.neighbours);
    if (!is_lattice || list.size() <= most) continue;
    list.resize(whole_shells(most, list[most].distance, D + 1,
                             [&](std::size_t n) { return list[n].distance; }));
  }
  choice.slot_of.resize(nodes.cloud.positions.size());
  for (std::int64_t slot = 0; slot < body.slots; ++slot) {
    if (body.number[slot] >= 0) choice.slot_of[body.number[slot]] = slot;
  }
  return choice;
}

template <class T, int D>
void make_room(const Case& settings, const Boundaries<D>& boundaries, PressureForces pressures,
               Body<T, D>& body) {
  if (body.source->stress) body.initial_stress[0].grow(body.slots, T(0));
  if (parameters_of(settings).stiffness_damping > 0) body.strain[0].grow(body.slots, T(0));
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
void hold(const Boundaries<D>& boundaries, double reach, Body<T, D>& body) {
  body.held.assign(body.blocks.size(), {});
  for (std::size_t b = 0; b < body.blocks.size(); ++b) {
    const NodeBlock& block = body.blocks[b];
    for (std::int64_t slot = block.first; slot < block.first + block.nodes; ++slot) {
      const Point<D>& x = body.start[slot];
      const double size = std::pow(body.mass[slot] / body.material.density, 1. / D);
      for (int w = 0; w < static_cast<int>(boundaries.walls.size()); ++w) {
        const Wall<D>& wall = boundaries.walls[w];
        if (!wall.is_attached() || wall.distance(x) >= reach * size + on_wall * body.resolution)
          continue;
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

bool has_cuts(const Case& settings, const BodyCase& body) {
  const auto number = &body - settings.bodies.data();
  return std::any_of(settings.cuts.begin(), settings.cuts.end(),
                     [number](const CutCase& cut) { return cut.body == number; });
}

bool has_elements(const Shape& shape) {
  return shape.kind == Shape::Kind::mesh &&
         (shape.file.ends_with(".msh") || shape.file.ends_with(".vtk"));
}

template <int D>
PlacedNodes<D> place_nodes(const Case& settings, const BodyCase& source,
                           const Boundaries<D>& boundaries) {
  const Shape& shape = source.geometry;
  const double spacing = settings.discretisation.spacing;
  std::optional<Point<D>> pitch;
  PlacedNodes<D> nodes;
  if (has_elements(shape)) {
    nodes.cloud = nodes_of_mesh<D>(read_volume_mesh(shape.file, D), shape.scale, shape.translate);
    nodes.reach = 0.25;  // vertices lie on the surface
    nodes.alpha = 0.2;
  } else if (parameters_of(settings).nodes == NodePlacement::octree) {
    const double coarsest = parameters_of(settings).coarsest_spacing;
    pitch = lattice_pitch<D>(shape, spacing);
    nodes.cloud = octree_nodes<D>(shape, {spacing, coarsest > 0 ? coarsest : 4 * spacing},
                                  CutPlaces<D>(settings, source, spacing / 2).take());
    nodes.reach = 0.5;
  } else {
    pitch = lattice_pitch<D>(shape, spacing);
    nodes.cloud = lattice_nodes<D>(shape, spacing);
    nodes.reach = 0.5;
    // Nodes at the surface have fewer neighbours, not farther ones, which would soften bending.
    const double widest = *std::max_element(pitch->begin(), pitch->end());
    for (int a = 0; a < D; ++a) nodes.stretch[a] = widest / (*pitch)[a];
    nodes.support = widest * lattice_support<D>(neighbour_count(settings));
    nodes.alpha = 0.1;
  }
  if (nodes.cloud.positions.empty()) {
    throw InputError(
        fmt::format("body `{}` holds no node; use a finer discretisation.spacing", source.name));
  }
  nodes.elastic_volumes = fit_to_walls<D>(boundaries, shape, pitch, nodes.cloud);
  return nodes;
}

template <class T, int D>
void make_nodes(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                const Boundaries<D>& boundaries, PressureForces pressures, Body<T, D>& body) {
  body.name = source.name;
  body.source = &source;
  body.material = kernels::with_scalar<T>(hyperelastic_material(source));
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
                        const Boundaries<D>& boundaries, Body<T, D>& body) {
  make_nodes(settings, source, nodes, boundaries, PressureForces::of_bonds, body);
  BondChoice<D> choice = choice_of(settings, nodes, body);
  if (parameters_of(settings).gradient == NodeGradient::patch_exact) {
    correct_weights(nodes.cloud, body, choice);
  } else if (!choice.is_lattice()) {
    balance_bonds(nodes.cloud, body, choice);
  }
  make_bonds(choice, body);
  if (!choice.is_lattice()) form_groups(body);
  if (!choice.is_lattice() || has_two_layers<D>(source.geometry, settings)) {
    choice.crowding = crowding(body);
    body.for_each_node(
        [&](std::int64_t slot) { body.frequency2[slot] *= static_cast<T>(choice.crowding); });
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

template PlacedNodes<2> place_nodes<2>(const Case&, const BodyCase&, const Boundaries<2>&);
template PlacedNodes<3> place_nodes<3>(const Case&, const BodyCase&, const Boundaries<3>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<2>&, const Boundaries<2>&,
                         PressureForces, Body<double, 2>&);
template BondChoice<2> make_body<double, 2>(const Case&, const BodyCase&, const PlacedNodes<2>&,
                                            const Boundaries<2>&, Body<double, 2>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<3>&, const Boundaries<3>&,
                         PressureForces, Body<double, 3>&);
template BondChoice<3> make_body<double, 3>(const Case&, const BodyCase&, const PlacedNodes<3>&,
                                            const Boundaries<3>&, Body<double, 3>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<2>&, const Boundaries<2>&,
                         PressureForces, Body<float, 2>&);
template BondChoice<2> make_body<float, 2>(const Case&, const BodyCase&, const PlacedNodes<2>&,
                                           const Boundaries<2>&, Body<float, 2>&);
template void make_nodes(const Case&, const BodyCase&, const PlacedNodes<3>&, const Boundaries<3>&,
                         PressureForces, Body<float, 3>&);
template BondChoice<3> make_body<float, 3>(const Case&, const BodyCase&, const PlacedNodes<3>&,
                                           const Boundaries<3>&, Body<float, 3>&);
template scheduler::Blocks number_blocks(State<double, 2>&);
template scheduler::Blocks number_blocks(State<double, 3>&);
template scheduler::Blocks number_blocks(State<float, 2>&);
template scheduler::Blocks number_blocks(State<float, 3>&);

}  // namespace pliant::point_based
