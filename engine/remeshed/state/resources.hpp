#pragma once

#include "engine/method/resources.hpp"
#include "engine/remeshed/state/fields.hpp"

/// The resources of the remeshed method; their numbers and names follow from the lists of fields
/// and groups.
namespace pliant::remeshed {

/// In the order of Group. Fields on the new lattice of a remeshing have their own groups, since its
/// blocks are different.
inline constexpr Table group_list = [] {
  using G = Group;
  return Table(&GroupDeclaration<Group>::group, G::record_numbers,
               {
                   {G::drift, "xi", true, {"Q0|Q3", "Q2|Q4"}},
                   {G::velocity, "u", true, {"Q0", "Q2|Q4", "Q3"}},
                   {G::material, "v, S|F", true, {"Q0", "Q2|Q4", "Q3"}},
                   {G::constants, "m, phi, d", true, {"Q0", "Q2: sigma of odd stages"}},
                   {G::memory, "p_i, J - 1", true, {"Q0", "Q2"}},
                   {G::stress, "sigma of even stages", true},
                   {G::interior, "interior slots"},
                   {G::kinds, "kinds"},
                   {G::image_sources, "image sources"},
                   {G::pair_stress, "pair stress"},
                   {G::fits, "ghost fits"},
                   {G::contact, "active ghosts"},
                   {G::corrections, "ghost corrections"},
                   {G::records, "surface records"},
                   {G::surface_samples, "surface samples"},
                   {G::surface_cells, "surface cells"},
                   {G::contact_points, "contact points"},
                   {G::tractions, "tractions"},
                   {G::contact_impulse, "contact impulse"},
                   {G::momentum, "momentum"},
                   {G::momentum_budgets, "momentum budgets"},
                   {G::motion, "motion"},
                   {G::motion_budgets, "motion budgets"},
                   {G::loaded_facets, "loaded facets"},
                   {G::shear_shares, "shear shares"},
                   {G::shear_forces, "shear forces"},
                   {G::closest_pairs, "closest pairs"},
                   {G::search_decisions, "search decisions"},
                   {G::sites, "sites"},
                   {G::cells, "cells"},
                   {G::neighbour_lists, "neighbour lists"},
                   {G::results, "results"},
                   {G::wall_impulse, "wall impulse"},
                   {G::bounds, "bounds"},
                   {G::new_state, "new state", true},
                   {G::new_kinds, "new kinds", true},
                   {G::particle_counts, "particle counts"},
                   {G::marks, "valid and inside marks", true},
                   {G::filtered, "filtered state"},
                   {G::extended, "extended phi"},
                   {G::closest, "closest points", false, {"even layers", "odd layers"}},
                   {G::new_corners, "new corners"},
                   {G::new_fits, "new ghost fits"},
                   {G::used, "used particles"},
                   {G::surface_packs, "new surface packs"},
                   {G::new_loads, "new loads"},
                   {G::record_numbers, "record numbers"},
               });
}();

inline constexpr ResourceNumbers resource_numbers(group_list);

/// The resource that has the memory of a field: the odd stages store sigma in constants of Q2, see
/// odd_stress_storage.
constexpr Resource<Group> stored(Resource<Group> resource) {
  const bool is_odd_stress = resource.group == Group::stress && resource.copy == 1;
  return is_odd_stress ? Resource<Group>{Group::constants, 1, resource.part} : resource;
}

namespace resource {

inline Resources of(Group group, int copy, Part part) {
  return {resource_numbers(stored({group, copy, part}))};
}

/// One copy of a group, in the slots of one part or in all slots.
inline Resources particles(Group group, int copy = 0) { return of(group, copy, Part::particles); }
inline Resources ghosts(Group group, int copy = 0) { return of(group, copy, Part::ghosts); }
inline Resources images(Group group, int copy = 0) { return of(group, copy, Part::images); }
inline Resources with_images(Group group) { return particles(group) + images(group); }
inline Resources slots(Group group, int copy = 0) {
  return particles(group, copy) + ghosts(group, copy) + images(group, copy);
}

/// Groups that are not divided into parts.
inline Resources whole(Group group, int copy = 0) { return of(group, copy, Part::particles); }

inline std::vector<std::string> names() { return resource_numbers.names(); }

}  // namespace resource

}  // namespace pliant::remeshed
