#pragma once

#include "engine/method/field.hpp"
#include "engine/method/resources.hpp"

/// The fields of the total Lagrangian method; docs/fields.md shows them as a table.
namespace pliant::total_lagrangian {

enum class Field {
  displacement,
  end_displacement,
  velocity,
  internal_force,
  sampled_displacement,
  sampled_force,
  traction,
  mass,
  inverse_mass,
  level_set,
  fraction,
  regular_fraction,
  initial_stress,
  fitted_cell,
  cut_cell,
  memory_pressure,
  volume_change,
  next_memory_pressure,
  next_volume_change,
  network,
  next_network,
  facet,
  patch,
  patch_force,
  constrained_particle,
  nodal_load,
  contact_list,
  contact_place,
  contact_normal,
  touch,
  result
};

/// Particles are nodes of the lattice of the undeformed body; stress points are its cells. Each
/// cell has the number of the slot at its lower corner.
enum class IndexSpace {
  particle,
  cell,
  facet,
  patch,
  constrained_particle,
  nodal_load,
  contact,
  contact_corner,
  contact_facet,
  block
};

inline constexpr Table index_spaces(
    &IndexSpaceDeclaration<IndexSpace>::space, IndexSpace::block,
    {
        {IndexSpace::particle, "particle", "a node of the lattice of the undeformed body"},
        {IndexSpace::cell, "cell", "a cell of that lattice, with one stress point"},
        {IndexSpace::facet, "facet", "a piece of the surface inside one cell"},
        {IndexSpace::patch, "patch", "a facet as far as a load acts on it"},
        {IndexSpace::constrained_particle, "constrained particle",
         "a particle whose velocity a wall sets"},
        {IndexSpace::nodal_load, "nodal load", "a particle and the patches that load it"},
        {IndexSpace::contact, "contact", "two bodies that a contact names"},
        {IndexSpace::contact_corner, "contact corner",
         "a corner of a surface that another one may touch"},
        {IndexSpace::contact_facet, "contact facet", "a piece of such a surface"},
        {IndexSpace::block, "block", "the slots that one worker takes at a time"},
    });

/// Fields that phases always read or write together.
enum class Group {
  displacement,
  velocity,
  internal_forces,
  tractions,
  constants,
  memory,
  next,
  surface,
  patch_forces,
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
  constexpr bool saved = true, shown = true, made_again = false;
  return Table(&Declaration::field, F::result, {
      {F::displacement, "d", "displacement", "m", vector, S::particle, G::displacement, not_at_all, 1, saved, shown},
      {F::end_displacement, "", "end_displacement", "m", vector, S::particle, G::next, not_at_all, 1, saved},
      {F::velocity, "u", "velocity", "m/s", vector, S::particle, G::velocity, not_at_all, 1, saved, shown},
      {F::internal_force, "", "internal", "N", vector, S::particle, G::internal_forces, not_at_all, 1, saved},
      {F::sampled_displacement, "", "sampled_displacement", "m", vector, S::particle, G::internal_forces, not_at_all, 1, saved},
      {F::sampled_force, "", "sampled_force", "N", vector, S::particle, G::internal_forces, not_at_all, 1, saved},
      {F::traction, "", "traction", "N", vector, S::particle, G::tractions, not_at_all, 1, saved},
      {F::mass, "m", "mass", "kg", scalar, S::particle, G::constants},
      {F::inverse_mass, "1/m", "inverse_mass", "1/kg", scalar, S::particle, G::constants},
      {F::level_set, "phi", "level_set", "m", scalar, S::particle, G::constants, not_at_all, 1, made_again, shown},
      {F::fraction, "f", "fraction", "1", scalar, S::cell, G::constants},
      {F::regular_fraction, "", "regular_fraction", "1", scalar, S::cell, G::constants},
      {F::initial_stress, "S0", "initial_stress", "Pa", symmetric_tensor, S::cell, G::constants},
      {F::fitted_cell, "A, q_b(X)", "fitted_cell", "1, m", list, S::cell, G::constants},
      {F::cut_cell, "m_b", "cut_cell", "1", list, S::cell, G::constants},
      {F::memory_pressure, "p_i", "memory_pressure", "Pa", prony, S::cell, G::memory, not_at_all, 1, saved},
      {F::volume_change, "J - 1", "volume_change", "1", scalar, S::cell, G::memory, not_at_all, 1, saved},
      {F::next_memory_pressure, "p_i", "next_memory_pressure", "Pa", prony, S::cell, G::next},
      {F::next_volume_change, "J - 1", "next_volume_change", "1", scalar, S::cell, G::next},
      {F::network, "A_i - I", "network", "1", prony_tensor, S::cell, G::memory, not_at_all, 1, saved},
      {F::next_network, "A_i - I", "next_network", "1", prony_tensor, S::cell, G::next},
      {F::facet, "X", "facet", "m", list, S::facet, G::surface},
      {F::patch, "", "patch", "1", list, S::patch, G::surface},
      {F::patch_force, "", "patch_force", "N", vector, S::patch, G::patch_forces},
      {F::constrained_particle, "n", "constrained_particle", "1", list, S::constrained_particle, G::surface},
      {F::nodal_load, "", "nodal_load", "1", list, S::nodal_load, G::surface},
      {F::contact_list, "", "contact_list", "1", list, S::contact, G::contact_lists},
      {F::contact_place, "x_v", "contact_place", "m", list, S::contact_corner, G::contact_places},
      {F::contact_normal, "n", "contact_normal", "1", list, S::contact_facet, G::contact_normals},
      {F::touch, "g, n, J", "touch", "m, 1, N s", list, S::block, G::touches},
      {F::result, "c, omega^2", "result", "m/s, 1/s^2", list, S::block, G::results},
  });
}();
// clang-format on

/// In the order of Group.
inline constexpr Table group_list(&GroupDeclaration<Group>::group, Group::results,
                                  {
                                      {Group::displacement, "d"},
                                      {Group::velocity, "u"},
                                      {Group::internal_forces, "internal forces"},
                                      {Group::tractions, "tractions"},
                                      {Group::constants, "m, phi, f"},
                                      {Group::memory, "p_i, A_i, J"},
                                      {Group::next, "next d, p_i, A_i, J"},
                                      {Group::surface, "surface"},
                                      {Group::patch_forces, "patch forces"},
                                      {Group::contact_lists, "contact lists"},
                                      {Group::contact_places, "contact places"},
                                      {Group::contact_normals, "contact normals"},
                                      {Group::touches, "touches"},
                                      {Group::results, "results"},
                                  });

inline constexpr ResourceNumbers resource_numbers(group_list);

inline Resources of(Group group) { return {resource_numbers({group})}; }

}  // namespace pliant::total_lagrangian
