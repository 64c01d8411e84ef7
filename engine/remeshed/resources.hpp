#pragma once

#include <string>
#include <vector>

#include "scheduler/phase.hpp"

/// What phases read and write, as the scheduler sees it: groups of fields that are always touched
/// together, one of each for every stage buffer.
namespace pliant::remeshed::resource {

using scheduler::FieldId;

/// Displacement, velocity, and volume with S or F, of stage buffer 0..2 (see buffer_of).
constexpr FieldId drift(int buffer) { return buffer; }
constexpr FieldId velocity(int buffer) { return 3 + buffer; }
constexpr FieldId material(int buffer) { return 6 + buffer; }
/// sigma of the even and of the odd stages.
constexpr FieldId stress(int parity) { return 9 + parity; }
/// What ghosts and images take from particles, of stage buffer 0..2: the same arrays as above, but
/// other slots of them, which no particle's own phase contact_points.
constexpr FieldId ghosts(int buffer) { return 11 + buffer; }
constexpr FieldId image_drift(int buffer) { return 14 + buffer; }
constexpr FieldId images(int buffer) { return 17 + buffer; }
/// Closest points and the level set rebuilt from them; the layers' marks alternate.
constexpr FieldId closest(int parity) { return 20 + parity; }
inline constexpr FieldId records = 22;          ///< of surface particles
inline constexpr FieldId constants = 23;        ///< mass, level set, carried displacement of ghosts
inline constexpr FieldId bounds = 24;           ///< extent of a block's particles
inline constexpr FieldId remeshed = 25;         ///< fields on the new lattice
inline constexpr FieldId remeshed_images = 26;  ///< the same, at images
inline constexpr FieldId filtered = 27;         ///< the same, filtered
inline constexpr FieldId extended = 28;         ///< level set continued through walls
inline constexpr FieldId kinds = 29;            ///< on the new lattice
inline constexpr FieldId fits = 30;             ///< ghosts and their coefficients
inline constexpr FieldId surface_packs = 31;
inline constexpr FieldId record_numbers = 32;
inline constexpr FieldId result = 33;         ///< largest values of a block
inline constexpr FieldId closest_pairs = 34;  ///< not seen by the stencil
inline constexpr FieldId verdicts = 35;       ///< whether the stencil serves a body
inline constexpr FieldId sites = 36;          ///< where a block's particles and ghosts are
inline constexpr FieldId cells = 37;          ///< the same, sorted by place
inline constexpr FieldId lists = 38;          ///< neighbours that the stencil does not see
inline constexpr FieldId contact = 39;        ///< which ghosts touch a contact wall, kinds
inline constexpr FieldId impulse = 40;        ///< of contact walls on a block
inline constexpr FieldId pair_stress = 41;    ///< of plain SPH
inline constexpr FieldId surface_samples =
    42;                                        ///< where a block's surface particles and ghosts are
inline constexpr FieldId surface_cells = 43;   ///< the same of bodies, sorted by place
inline constexpr FieldId contact_points = 44;  ///< ghosts that touch other bodies
inline constexpr FieldId tractions = 45;       ///< there
inline constexpr FieldId momentum = 46;        ///< of a block's particles
inline constexpr FieldId momentum_budgets = 47;  ///< of bodies

inline std::vector<std::string> names() {
  std::vector<std::string> names;
  const auto add_each = [&](std::initializer_list<const char*> fields) {
    for (const char* field : fields) {
      for (const char* buffer : {"Q0", "Q2|Q4", "Q3"}) {
        names.push_back(std::string(field) + " of " + buffer);
      }
    }
  };
  add_each({"xi", "u", "v, S|F"});
  names.insert(names.end(), {"sigma, even stages", "sigma, odd stages"});
  add_each({"ghosts", "xi of images", "images"});
  names.insert(names.end(), {"closest points, even",
                             "closest points, odd",
                             "surface records",
                             "m, phi, d of ghosts",
                             "bounds",
                             "remeshed",
                             "remeshed images",
                             "filtered",
                             "phi extended",
                             "kinds",
                             "ghost fits",
                             "surface packs",
                             "record numbers",
                             "result",
                             "closest pairs",
                             "verdicts",
                             "sites",
                             "cells",
                             "neighbour lists",
                             "contact",
                             "wall impulse",
                             "pair stress",
                             "surface samples",
                             "surface cells",
                             "contact_points",
                             "tractions",
                             "momentum",
                             "momentum_budgets"});
  return names;
}

}  // namespace pliant::remeshed::resource
