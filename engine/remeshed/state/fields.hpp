#pragma once

#include <span>

#include "engine/method/field.hpp"
#include "engine/remeshed/state/index_spaces.hpp"
#include "kernels/layout.hpp"

/// The fields of the remeshed method; docs/fields.md shows them as a table.
namespace pliant::remeshed {

enum class Field {
  // The state, in a FieldStore.
  drift,
  velocity,
  volume,
  material,
  mass,
  level_set,
  displacement,
  memory_pressure,
  // Data of slots between remeshings.
  stress,
  volume_change,
  interior,
  kind,
  pack_state,
  image,
  pair_stress,
  artificial_stress,
  // Ghosts and the data that they read.
  ghost_slot,
  wall,
  active,
  pressure,
  ghost_face,
  ghost_face_load,
  ghost_face_share,
  edge,
  normal,
  foot,
  terms,
  constrained_sum,
  surface_sum,
  correction,
  lasting_correction,
  initial_drift,
  drift_increment,
  pairs_begin,
  pairs,
  wall_begin,
  wall_distance,
  contact,
  contact_height,
  contact_area,
  surface_pack,
  record_slot,
  surface_distance,
  record_load,
  loaded_share,
  record_face,
  record_slope,
  record,
  // Contact between bodies.
  surface_sample,
  surface_cells,
  contact_ghost,
  contact_number,
  gap,
  area,
  contact_begin,
  contact_record,
  contact_coefficient,
  traction,
  contact_impulse,
  block_momentum,
  momentum_budget,
  block_motion,
  motion_budget,
  loaded_facet,
  shear_share,
  shear_force,
  // Neighbour search.
  closest_pair,
  search_decision,
  site,
  cell_list,
  neighbours,
  // Blocks.
  stage_result,
  wall_impulse,
  particle_bounds,
  // Remeshing: the new lattice.
  new_state,
  new_kind,
  particle_count,
  valid,
  inside,
  filtered_state,
  extended_level_set,
  closest_point,
  closest_point_layer,
  new_corner,
  new_ghosts,
  used,
  new_surface_pack,
  new_record_load,
  record_number
};

/// Fields that phases always read or write together.
enum class Group {
  drift,
  velocity,
  material,
  constants,
  memory,
  stress,
  interior,
  kinds,
  image_sources,
  pair_stress,
  fits,
  contact,
  corrections,
  records,
  surface_samples,
  surface_cells,
  contact_points,
  tractions,
  contact_impulse,
  momentum,
  momentum_budgets,
  motion,
  motion_budgets,
  loaded_facets,
  shear_shares,
  shear_forces,
  closest_pairs,
  search_decisions,
  sites,
  cells,
  neighbour_lists,
  results,
  wall_impulse,
  bounds,
  new_state,
  new_kinds,
  particle_counts,
  marks,
  filtered,
  extended,
  closest,
  new_corners,
  new_fits,
  used,
  surface_packs,
  new_loads,
  record_numbers
};

using Declaration = FieldDeclaration<Field, IndexSpace, Group>;

// clang-format off
inline constexpr Table field_list = [] {
  using enum Rank;
  using enum Remeshed;
  using F = Field;
  using S = IndexSpace;
  using G = Group;
  constexpr bool saved = true, shown = true, hidden = false, made_again = false;
  return Table(&Declaration::field, F::record_number, {
      {F::drift, "xi", "drift", "m", vector, S::slot, G::drift, not_at_all, 2, saved},
      {F::velocity, "u", "velocity", "m/s", vector, S::slot, G::velocity, as_mass_mean, 3, saved, shown},
      {F::volume, "v", "volume", "m^D", scalar, S::slot, G::material, as_density_times_volume, 3, saved},
      {F::material, "S|F", "material_state", "Pa|1", material, S::slot, G::material, as_volume_mean, 3, saved},
      {F::mass, "m", "mass", "kg", scalar, S::slot, G::constants, as_density_times_volume, 2, saved},
      {F::level_set, "phi", "level_set", "m", scalar, S::slot, G::constants, as_mean, 2, saved, shown},
      {F::displacement, "d", "displacement", "m", vector, S::slot, G::constants, as_volume_mean, 2, saved, shown},
      {F::memory_pressure, "p_i", "memory_pressure", "Pa", prony, S::slot, G::memory, as_volume_mean, 2, saved},

      {F::stress, "sigma", "stress", "Pa", symmetric_tensor, S::slot, G::stress, not_at_all, 2, saved, shown,
       "odd stages: mass, level_set and displacement of Q2, which are free within a step"},
      {F::volume_change, "J - 1", "volume_change", "1", scalar, S::slot, G::memory},
      {F::interior, "", "interior", "1", scalar, S::slot, G::interior},
      {F::kind, "", "kind", "1", scalar, S::slot, G::kinds, not_at_all, 1, saved, shown},
      {F::pack_state, "", "pack_state", "1", scalar, S::pack, G::kinds},
      {F::image, "", "image", "1", list, S::image, G::image_sources},
      {F::pair_stress, "sigma/rho^2", "pair_stress", "m^5/(kg s^2)", symmetric_tensor, S::slot, G::pair_stress},
      {F::artificial_stress, "R", "artificial_stress", "m^5/(kg s^2)", symmetric_tensor, S::slot, G::pair_stress},

      {F::ghost_slot, "", "slot", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::wall, "", "wall", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::active, "", "active", "1", scalar, S::ghost, G::contact, not_at_all, 1, saved},
      {F::pressure, "", "pressure", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::ghost_face, "N", "ghost_face", "1", vector, S::ghost, G::fits, not_at_all, 1, saved},
      {F::ghost_face_load, "", "ghost_face_load", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::ghost_face_share, "", "ghost_face_share", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::edge, "", "edge", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::normal, "n", "normal", "1", vector, S::ghost, G::fits, not_at_all, 1, saved},
      {F::foot, "x_f", "foot", "m", vector, S::ghost, G::fits, not_at_all, 1, saved},
      {F::terms, "", "terms", "1", fit_terms, S::ghost, G::fits, not_at_all, 1, saved},
      {F::constrained_sum, "sum b_gi", "constrained_sum", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::surface_sum, "sum a_gi", "surface_sum", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::correction, "", "correction", "m/s", vector, S::ghost, G::corrections},
      {F::lasting_correction, "", "lasting", "m/s", vector, S::ghost, G::corrections, not_at_all, 1, saved},
      {F::initial_drift, "xi", "initial_drift", "m", vector, S::ghost, G::corrections},
      {F::drift_increment, "", "drift_increment", "m", vector, S::ghost, G::corrections},
      {F::pairs_begin, "", "begin", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::pairs, "", "pairs", "1", scalar, S::pair, G::fits, not_at_all, 1, saved},
      {F::wall_begin, "", "wall_begin", "1", scalar, S::ghost, G::fits, not_at_all, 1, saved},
      {F::wall_distance, "d/h", "wall_distance", "1", scalar, S::pair, G::fits, not_at_all, 1, saved},
      {F::contact, "", "contact", "1", scalar, S::wall_ghost, G::fits, not_at_all, 1, saved},
      {F::contact_height, "", "contact_height", "m", scalar, S::wall_ghost, G::fits, not_at_all, 1, saved},
      {F::contact_area, "", "contact_area", "m^(D-1)", scalar, S::wall_ghost, G::fits, not_at_all, 1, saved},
      {F::surface_pack, "", "packs", "1", list, S::block, G::fits, not_at_all, 1, saved},
      {F::record_slot, "", "slot_of_record", "1", scalar, S::record, G::fits},
      {F::surface_distance, "phi/h", "surface_distance", "1", scalar, S::record, G::fits, not_at_all, 1, saved},
      {F::record_load, "", "load", "1", scalar, S::record, G::fits, not_at_all, 1, saved},
      {F::loaded_share, "", "loaded_share", "1", scalar, S::record, G::fits, not_at_all, 1, saved},
      {F::record_face, "N", "face", "1", vector, S::record, G::fits, not_at_all, 1, saved},
      {F::record_slope, "grad phi", "slope", "1", vector, S::record, G::fits, not_at_all, 1, saved},
      {F::record, "sigma, p, u, grad phi", "record", "Pa, m/s, 1", Rank::record, S::record, G::records},

      {F::surface_sample, "", "surface_sample", "h", list, S::block, G::surface_samples},
      {F::surface_cells, "", "surface_cells", "h", list, S::body, G::surface_cells},
      {F::contact_ghost, "", "contact_ghost", "1", scalar, S::contact_point, G::contact_points},
      {F::contact_number, "", "contact_number", "1", scalar, S::contact_point, G::contact_points},
      {F::gap, "g", "gap", "m", scalar, S::contact_point, G::contact_points},
      {F::area, "", "area", "m^(D-1)", scalar, S::contact_point, G::contact_points},
      {F::contact_begin, "", "contact_begin", "1", scalar, S::contact_point, G::contact_points},
      {F::contact_record, "", "contact_record", "1", scalar, S::contact_pair, G::contact_points},
      {F::contact_coefficient, "", "contact_coefficient", "1", scalar, S::contact_pair, G::contact_points},
      {F::traction, "t", "traction", "Pa", vector, S::contact_point, G::tractions},
      {F::contact_impulse, "", "contact_impulse", "N s", vector, S::block, G::contact_impulse},
      {F::block_momentum, "", "block_momentum", "kg, N s", vector, S::block, G::momentum},
      {F::momentum_budget, "M, P", "momentum_budget", "kg, N s", vector, S::body, G::momentum_budgets, not_at_all, 1, saved},

      {F::block_motion, "", "block_motion", "kg, N s, N m s", list, S::block, G::motion},
      {F::motion_budget, "M, P, L", "motion_budget", "kg, N s, N m s", list, S::body, G::motion_budgets, not_at_all, 1, saved},

      {F::loaded_facet, "", "loaded_facet", "m", list, S::block, G::loaded_facets},
      {F::shear_share, "", "shear_share", "1", list, S::block, G::shear_shares},
      {F::shear_force, "", "shear_force", "N", vector, S::block, G::shear_forces},
      {F::closest_pair, "r/h", "closest_pair", "1", scalar, S::block, G::closest_pairs},
      {F::search_decision, "", "search_decision", "1", scalar, S::body, G::search_decisions},
      {F::site, "x/h", "site", "1", list, S::block, G::sites},
      {F::cell_list, "", "cell_list", "1", list, S::body, G::cells},
      {F::neighbours, "", "neighbours", "1", list, S::pack, G::neighbour_lists},

      {F::stage_result, "abs(eps), c", "stage_result", "1/s, m/s", list, S::block, G::results},
      {F::wall_impulse, "", "wall_impulse", "N s", vector, S::block, G::wall_impulse},
      {F::particle_bounds, "", "particle_bounds", "1", list, S::block, G::bounds},

      {F::new_state, "", "new_state", "", list, S::new_slot, G::new_state, not_at_all, 1, made_again, hidden,
       "Q2: all fields of a state"},
      {F::new_kind, "", "new_kind", "1", scalar, S::new_slot, G::new_kinds},
      {F::particle_count, "", "particle_count", "1", scalar, S::block, G::particle_counts},
      {F::valid, "", "valid", "1", scalar, S::new_slot, G::marks, not_at_all, 1, made_again, hidden,
       "Q2: drift"},
      {F::inside, "", "inside", "1", scalar, S::new_slot, G::marks, not_at_all, 1, made_again, hidden,
       "Q2: drift"},
      {F::filtered_state, "", "filtered_state", "", list, S::new_slot, G::filtered, not_at_all, 1, made_again, hidden,
       "Q3: velocity, volume (for the mass) and material_state"},
      {F::extended_level_set, "phi", "extended_level_set", "m", scalar, S::new_slot, G::extended, not_at_all, 1, made_again, hidden,
       "Q3: material_state"},
      {F::closest_point, "", "closest_point", "h", vector, S::new_slot, G::closest, not_at_all, 1, made_again, hidden,
       "Q3: velocity"},
      {F::closest_point_layer, "", "closest_point_layer", "1", scalar, S::new_slot, G::closest, not_at_all, 2},
      {F::new_corner, "x", "new_corner", "m", list, S::block, G::new_corners},
      {F::new_ghosts, "", "new_ghosts", "", list, S::block, G::new_fits},
      {F::used, "", "used", "1", scalar, S::new_slot, G::used},
      {F::new_surface_pack, "", "new_surface_pack", "1", list, S::block, G::surface_packs},
      {F::new_record_load, "", "new_load", "1", scalar, S::record, G::new_loads},
      {F::record_number, "", "record_number", "1", scalar, S::new_slot, G::record_numbers, not_at_all, 1, made_again, hidden,
       "used"},
  });
}();
// clang-format on

/// The fields of the state, in a FieldStore.
inline constexpr int state_field_count = static_cast<int>(Field::memory_pressure) + 1;
inline constexpr std::span<const Declaration> state_fields(field_list.begin(), state_field_count);

/// Whether the Runge-Kutta method advances a field of the state, (RP.21).
constexpr bool is_evolving(const Declaration& field) { return field.field <= Field::material; }

}  // namespace pliant::remeshed
