#pragma once

#include <array>
#include <cstddef>
#include <string_view>

/// A row in the list of fields of a method. Storage, stage copies, checkpoints, frames, the
/// scheduler's resources and docs/fields.md follow from these lists.
namespace pliant {

/// The components of one item of a field.
enum class Rank {
  scalar,
  vector,            ///< D
  symmetric_tensor,  ///< D (D + 1)/2
  material,          ///< S, a symmetric tensor, or F, D x D
  prony,             ///< one value for each term of the material's Prony series
  prony_tensor,      ///< symmetric tensors: one for each of these terms, and one more
  fit_terms,         ///< coefficients of the three fits of a ghost
  record,            ///< values of a surface record
  list               ///< any number of values for each item
};

/// One index space of a method: fields have one value, vector or list for each of its elements.
template <class IndexSpace>
struct IndexSpaceDeclaration {
  IndexSpace space;
  std::string_view name, meaning;
};

/// How a field is transferred to the new lattice, (RP.32) and (RP.33).
enum class Remeshed { not_at_all, as_density_times_volume, as_mass_mean, as_volume_mean, as_mean };

/// One field of a method. The enumerations of the method name its fields, index spaces, and groups.
/// A group holds fields that phases always read or write together; the scheduler sees only groups.
template <class Field, class IndexSpace, class Group>
struct FieldDeclaration {
  Field field;
  std::string_view symbol, name, unit;  ///< the unit in SI, "1" for a pure number
  Rank rank;
  IndexSpace space;
  Group group;
  Remeshed remeshed = Remeshed::not_at_all;
  int copies = 1;  ///< one for each Runge-Kutta stage, or for each of the passes that alternate
  bool is_saved = false;                 ///< in checkpoints
  bool is_shown = false;                 ///< in frames
  std::string_view shares_storage = "";  ///< other fields that use the same memory at other times
};

/// A list with one row for each enumerator of Name, in the same order.
template <class Name, class Row, std::size_t rows>
class Table {
 public:
  /// `name` is the member with the enumerator of a row; `last` is the last enumerator. Does not
  /// compile if rows are missing, superfluous or out of order.
  consteval Table(Name Row::*name, Name last, const Row (&list)[rows])
      : list_(std::to_array(list)) {
    if (rows != static_cast<std::size_t>(last) + 1) throw "one row for each enumerator";
    for (std::size_t i = 0; i < rows; ++i) {
      if (list[i].*name != static_cast<Name>(i)) throw "rows in the order of the enumerators";
    }
  }

  constexpr const Row& operator[](Name name) const { return list_[static_cast<std::size_t>(name)]; }
  constexpr const Row* begin() const { return list_.data(); }
  constexpr const Row* end() const { return list_.data() + rows; }

 private:
  std::array<Row, rows> list_;
};

}  // namespace pliant
