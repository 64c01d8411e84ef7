#pragma once

#include <cstddef>
#include <string_view>

/// What a row of a method's list of fields says. Storage, stage copies, checkpoints, frames, the
/// scheduler's resources and docs/fields.md follow from those lists.
namespace pliant {

/// The components of one item of a field.
enum class Rank {
  scalar,
  vector,            ///< D
  symmetric_tensor,  ///< D (D + 1)/2
  material,          ///< S, a symmetric tensor, or F, D x D
  prony,             ///< one for each term of the material's Prony series
  corner_modes,      ///< a vector for each mode of the corners of a cell
  fit_terms,         ///< coefficients of the three fits of a ghost
  record,            ///< values of a surface record
  list               ///< as many as the item has
};

/// One index space of a method: what its fields have one value, vector or list for.
template <class IndexSpace>
struct IndexSpaceDeclaration {
  IndexSpace space;
  std::string_view name, meaning;
};

/// How a field crosses to the new lattice, (RP.32) and (RP.33).
enum class Remeshed { not_at_all, as_density_times_volume, as_mass_mean, as_volume_mean, as_mean };

/// One field of a method, whose enumerations name its fields, index spaces, and groups: a group
/// holds fields that phases always read or write together, and is what the scheduler sees.
template <class Field, class IndexSpace, class Group>
struct FieldDeclaration {
  Field field;
  std::string_view symbol, name, unit;  ///< the unit in SI, "1" for a pure number
  Rank rank;
  IndexSpace space;
  Group group;
  Remeshed remeshed = Remeshed::not_at_all;
  int copies = 1;                        ///< of Runge-Kutta stages, or of passes that alternate
  bool is_saved = false;                 ///< in checkpoints
  bool is_shown = false;                 ///< in frames
  std::string_view shares_storage = "";  ///< what else lies in its memory at other times
};

/// Whether a list has one row for each of its enumerators, in their order.
template <class List, class Row, class Name>
constexpr bool is_in_order(const List& list, Name Row::*name, Name last) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].*name != static_cast<Name>(i)) return false;
  }
  return list.size() == static_cast<std::size_t>(last) + 1;
}

}  // namespace pliant
