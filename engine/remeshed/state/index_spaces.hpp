#pragma once

#include "engine/method/field.hpp"

namespace pliant::remeshed {

/// The index spaces of the fields of the remeshed method.
enum class IndexSpace {
  slot,
  pack,
  image,
  ghost,
  pair,
  wall_ghost,
  rim_ghost,
  record,
  contact_point,
  contact_pair,
  block,
  body,
  new_slot
};

// clang-format off
inline constexpr Table index_spaces = [] {
  using S = IndexSpace;
  return Table(&IndexSpaceDeclaration<IndexSpace>::space, S::new_slot, {
      {S::slot, "slot", "a place in storage, which belongs to a lattice cell; vacant, or with a particle, ghost or image"},
      {S::pack, "pack", "as many neighbouring slots as fill a cache line"},
      {S::image, "image", "a slot beyond a period, with the slot that it repeats"},
      {S::ghost, "ghost", "a slot outside of the body, at a free surface, a wall, or another body"},
      {S::pair, "pair", "a ghost and a particle of its fits"},
      {S::wall_ghost, "wall ghost", "a ghost beyond a contact wall"},
      {S::rim_ghost, "rim ghost", "a ghost of the free surface behind a wall that holds the body"},
      {S::record, "record", "a particle that fits of ghosts read"},
      {S::contact_point, "contact point", "a ghost whose foot point lies on another body"},
      {S::contact_pair, "contact pair", "a contact point and a particle of the other body"},
      {S::block, "block", "the slots that one worker takes at a time"},
      {S::body, "body", "a body"},
      {S::new_slot, "new slot", "a slot of the new lattice, in a remeshing"},
  });
}();
// clang-format on

}  // namespace pliant::remeshed
