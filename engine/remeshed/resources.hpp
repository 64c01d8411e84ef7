#pragma once

#include <string>
#include <vector>

#include "scheduler/phase.hpp"

/// What phases read and write, as the scheduler sees it: groups of fields that are always touched
/// together, one of each for every stage buffer.
namespace pliant::remeshed::resource {

using scheduler::FieldId;

/// Displacement, velocity, and volume with S or F, of stage buffer 0..3 (Q0, Q2, Q3, Q4).
constexpr FieldId drift(int buffer) { return buffer; }
constexpr FieldId velocity(int buffer) { return 4 + buffer; }
constexpr FieldId material(int buffer) { return 8 + buffer; }
/// sigma of the even and of the odd stages.
constexpr FieldId stress(int parity) { return 12 + parity; }
inline constexpr FieldId records = 14;        ///< of surface particles
inline constexpr FieldId constants = 15;      ///< mass, level set, carried displacement, kinds
inline constexpr FieldId bounds = 16;         ///< extent of a block's particles
inline constexpr FieldId remeshed = 17;       ///< fields on the new lattice
inline constexpr FieldId filtered = 18;       ///< the same, filtered
inline constexpr FieldId extended = 19;       ///< level set continued through walls
inline constexpr FieldId closest = 20;        ///< level set rebuilt, closest points
inline constexpr FieldId kinds = 21;          ///< on the new lattice
inline constexpr FieldId surface_marks = 22;  ///< particles that ghosts read
inline constexpr FieldId fits = 23;           ///< ghosts and their coefficients
inline constexpr FieldId surface_packs = 24;
inline constexpr FieldId record_numbers = 25;
inline constexpr FieldId neighbours = 26;  ///< lists beyond the stencil
inline constexpr FieldId cells = 27;       ///< particles sorted into cells
inline constexpr FieldId result = 28;      ///< largest values of a block

inline std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const char* field : {"xi", "u", "v, S|F"}) {
    for (const char* buffer : {"Q0", "Q2", "Q3", "Q4"}) {
      names.push_back(std::string(field) + " of " + buffer);
    }
  }
  for (const char* name :
       {"sigma, even stages", "sigma, odd stages", "surface records", "m, phi, d, kinds", "bounds",
        "remeshed", "filtered", "phi extended", "closest points", "new kinds", "surface marks",
        "ghost fits", "surface packs", "record numbers", "neighbour lists", "cells", "result"}) {
    names.emplace_back(name);
  }
  return names;
}

}  // namespace pliant::remeshed::resource
