#pragma once

#include "engine/method/field.hpp"
#include "engine/method/resources.hpp"

/// The fields of finite elements; docs/fields.md shows them as a table.
namespace pliant::finite_elements {

enum class Field {
  displacement,
  end_displacement,
  velocity,
  end_velocity,
  velocity_gain,
  mass,
  inverse_mass,
  volume,
  traction,
  corner,
  shape,
  initial_stress,
  halo,
  constrained_node,
  sampled_displacement,
  sampled_force,
  memory_pressure,
  volume_change,
  own_sum,
  halo_sum,
  pressure,
  contact_list,
  contact_place,
  contact_normal,
  touch,
  result
};

enum class IndexSpace {
  node,
  element,
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
        {IndexSpace::node, "node", "a corner of elements, with its share of their volume"},
        {IndexSpace::element, "element", "a tetrahedron, in 2D a triangle, of the undeformed body"},
        {IndexSpace::halo, "halo",
         "a node of another block at a corner of an element of the block"},
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
  constants,
  loads,
  own_sums,
  halo_sums,
  pressures,
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
      {F::mass, "m", "mass", "kg", scalar, S::node, G::constants},
      {F::inverse_mass, "1/m", "inverse_mass", "1/kg", scalar, S::node, G::constants},
      {F::volume, "V", "volume", "m^D", scalar, S::node, G::constants},
      {F::traction, "", "traction", "N", vector, S::node, G::loads},
      {F::corner, "", "corner", "1", list, S::element, G::constants},
      {F::shape, "grad N, V", "shape", "1/m, m^D", list, S::element, G::constants},
      {F::initial_stress, "S0", "initial_stress", "Pa", list, S::element, G::constants},
      {F::halo, "", "halo", "1", scalar, S::halo, G::constants},
      {F::constrained_node, "n", "constrained_node", "1", list, S::constrained_node, G::constants},
      {F::sampled_displacement, "", "sampled_displacement", "m", vector, S::node, G::own_sums, not_at_all, 1, saved},
      {F::sampled_force, "", "sampled_force", "N", vector, S::node, G::own_sums, not_at_all, 1, saved},
      {F::memory_pressure, "p_i", "memory_pressure", "Pa", prony, S::node, G::pressures, not_at_all, 1, saved},
      {F::volume_change, "theta", "volume_change", "1", scalar, S::node, G::pressures, not_at_all, 1, saved},
      {F::own_sum, "f", "own_sum", "N", vector, S::node, G::own_sums},
      {F::halo_sum, "f", "halo_sum", "N", vector, S::halo, G::halo_sums},
      {F::pressure, "p", "pressure", "Pa", scalar, S::node, G::pressures},
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
                                      {Group::constants, "constants"},
                                      {Group::loads, "loads"},
                                      {Group::own_sums, "own sums"},
                                      {Group::halo_sums, "halo sums"},
                                      {Group::pressures, "pressures"},
                                      {Group::contact_lists, "contact lists"},
                                      {Group::contact_places, "contact places"},
                                      {Group::contact_normals, "contact normals"},
                                      {Group::touches, "touches"},
                                      {Group::results, "results"},
                                  });

inline constexpr ResourceNumbers resource_numbers(group_list);

inline Resources of(Group group) { return {resource_numbers({group})}; }

}  // namespace pliant::finite_elements
