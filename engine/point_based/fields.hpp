#pragma once

#include "engine/method/field.hpp"
#include "engine/method/resources.hpp"

/// The fields of the point-based method; docs/fields.md shows them as a table.
namespace pliant::point_based {

enum class Field {
  displacement,
  end_displacement,
  velocity,
  end_velocity,
  velocity_gain,
  strain,
  memory_pressure,
  volume_change,
  network,
  mass,
  inverse_mass,
  volume,
  stiffness,
  frequency2,
  moment,
  share,
  initial_stress,
  pressure_load,
  traction,
  kept_gradient,
  degenerate_node,
  neighbour,
  bond,
  halo,
  constrained_node,
  sampled_displacement,
  sampled_force,
  own_force,
  halo_force,
  contact_list,
  contact_place,
  contact_normal,
  touch,
  result
};

enum class IndexSpace {
  node,
  bond,
  halo,
  constrained_node,
  contact,
  contact_corner,
  contact_facet,
  block
};

inline constexpr Table index_spaces(
    &IndexSpaceDeclaration<IndexSpace>::space, IndexSpace::block,
    {
        {IndexSpace::node, "node", "a point of the undeformed body with a share of its volume"},
        {IndexSpace::bond, "bond", "a node and one of its neighbours"},
        {IndexSpace::halo, "halo",
         "a node of another block that a node of the block has as neighbour"},
        {IndexSpace::constrained_node, "constrained node", "a node whose velocity a wall sets"},
        {IndexSpace::contact, "contact", "two bodies that a contact names"},
        {IndexSpace::contact_corner, "contact corner",
         "a corner of a surface that another one may touch"},
        {IndexSpace::contact_facet, "contact facet", "a piece of such a surface"},
        {IndexSpace::block, "block", "the nodes that one worker takes at a time"},
    });

/// Fields that phases always read or write together.
enum class Group {
  displacement,
  velocity,
  strain,
  mass,
  constants,
  loads,
  own_forces,
  halo_forces,
  contact_lists,
  contact_places,
  contact_normals,
  touches,
  results
};

using Declaration = FieldDeclaration<Field, IndexSpace, Group>;

// clang-format off
inline constexpr Table field_list = [] {
  using enum Rank;
  using enum Remeshed;
  using F = Field;
  using S = IndexSpace;
  using G = Group;
  constexpr bool saved = true, shown = true;
  return Table(&Declaration::field, F::result, {
      {F::displacement, "d", "displacement", "m", vector, S::node, G::displacement, not_at_all, 1, saved, shown},
      {F::end_displacement, "", "end_displacement", "m", vector, S::node, G::displacement, not_at_all, 1, saved},
      {F::velocity, "u", "velocity", "m/s", vector, S::node, G::velocity, not_at_all, 1, saved, shown},
      {F::end_velocity, "", "end_velocity", "m/s", vector, S::node, G::velocity, not_at_all, 1, saved},
      {F::velocity_gain, "", "velocity_gain", "m/s", vector, S::node, G::velocity, not_at_all, 1, saved},
      {F::strain, "E", "strain", "1", symmetric_tensor, S::node, G::strain, not_at_all, 1, saved},
      {F::memory_pressure, "p_i", "memory_pressure", "Pa", prony, S::node, G::strain, not_at_all, 1, saved},
      {F::volume_change, "theta", "volume_change", "1", scalar, S::node, G::strain, not_at_all, 1, saved},
      {F::network, "A_i - I", "network", "1", prony_tensor, S::node, G::strain, not_at_all, 1, saved},
      {F::mass, "m", "mass", "kg", scalar, S::node, G::mass},
      {F::inverse_mass, "1/m", "inverse_mass", "1/kg", scalar, S::node, G::constants},
      {F::volume, "V", "volume", "m^D", scalar, S::node, G::constants},
      {F::stiffness, "V kappa", "stiffness", "N/m", scalar, S::node, G::constants},
      {F::frequency2, "lambda", "frequency2", "1/s^2", scalar, S::node, G::constants},
      {F::moment, "A", "moment", "m^2", symmetric_tensor, S::node, G::constants},
      {F::share, "", "share", "1", scalar, S::node, G::constants},
      {F::initial_stress, "S0", "initial_stress", "Pa", symmetric_tensor, S::node, G::constants},
      {F::pressure_load, "p a", "pressure_load", "N", vector, S::node, G::loads},
      {F::traction, "", "traction", "N", vector, S::node, G::loads},
      {F::kept_gradient, "D", "kept_gradient", "1", material, S::node, G::constants, not_at_all, 1, saved},
      {F::degenerate_node, "Q", "degenerate_node", "1", list, S::node, G::constants},
      {F::neighbour, "", "neighbour", "1", scalar, S::bond, G::constants},
      {F::bond, "g, w", "bond", "1/m, 1", list, S::bond, G::constants},
      {F::halo, "", "halo", "1", scalar, S::halo, G::constants},
      {F::constrained_node, "n", "constrained_node", "1", list, S::constrained_node, G::constants},
      {F::sampled_displacement, "", "sampled_displacement", "m", vector, S::node, G::own_forces, not_at_all, 1, saved},
      {F::sampled_force, "", "sampled_force", "N", vector, S::node, G::own_forces, not_at_all, 1, saved},
      {F::own_force, "f", "own_force", "N", vector, S::node, G::own_forces},
      {F::halo_force, "f", "halo_force", "N", vector, S::halo, G::halo_forces},
      {F::contact_list, "", "contact_list", "1", list, S::contact, G::contact_lists},
      {F::contact_place, "x_v", "contact_place", "m", list, S::contact_corner, G::contact_places},
      {F::contact_normal, "n", "contact_normal", "1", list, S::contact_facet, G::contact_normals},
      {F::touch, "g, n, J", "touch", "m, 1, N s", list, S::block, G::touches},
      {F::result, "", "result", "1", list, S::block, G::results},
  });
}();
// clang-format on

/// In the order of Group.
inline constexpr Table group_list(&GroupDeclaration<Group>::group, Group::results,
                                  {
                                      {Group::displacement, "d"},
                                      {Group::velocity, "u"},
                                      {Group::strain, "E, p_i, A_i"},
                                      {Group::mass, "m"},
                                      {Group::constants, "constants"},
                                      {Group::loads, "loads"},
                                      {Group::own_forces, "own forces"},
                                      {Group::halo_forces, "halo forces"},
                                      {Group::contact_lists, "contact lists"},
                                      {Group::contact_places, "contact places"},
                                      {Group::contact_normals, "contact normals"},
                                      {Group::touches, "touches"},
                                      {Group::results, "results"},
                                  });

inline constexpr ResourceNumbers resource_numbers(group_list);

inline Resources of(Group group) { return {resource_numbers({group})}; }

}  // namespace pliant::point_based
