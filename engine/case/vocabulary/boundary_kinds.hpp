#pragma once

#include <array>
#include <string_view>

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/word.hpp"

/// The kinds of boundaries, one row for each: word, keys, meaning, and what methods need to know.
namespace pliant {

/// Whether a kind of boundary uses a key.
enum class Use { no, optional, required };

struct BoundaryKind {
  BoundaryCase::Kind kind;
  std::string_view word;
  bool is_wall;      ///< a rigid solid; otherwise a load on the free surface
  bool is_attached;  ///< the body can never separate from it
  Use motion, rotation, friction, pressure, traction;
  std::string_view meaning;
};

inline constexpr auto boundary_kinds = [] {
  using Kind = BoundaryCase::Kind;
  return std::to_array<BoundaryKind>({
      {Kind::fixed, "fixed", true, true, Use::no, Use::no, Use::no, Use::no, Use::no,
       "no-slip wall at rest"},
      {Kind::moving_wall, "moving_wall", true, true, Use::required, Use::optional, Use::no, Use::no,
       Use::no, "no-slip wall with a prescribed motion"},
      {Kind::slip_wall, "slip_wall", true, true, Use::optional, Use::no, Use::no, Use::no, Use::no,
       "wall along which the body slides without friction and from which it cannot separate"},
      {Kind::contact_wall, "contact_wall", true, false, Use::optional, Use::optional, Use::optional,
       Use::no, Use::no,
       "wall with unilateral contact: bodies can meet it and separate from it (RP.52)"},
      {Kind::pressure, "pressure", false, false, Use::no, Use::no, Use::no, Use::required, Use::no,
       "pressure on the part of the free surface that lies in a region"},
      {Kind::traction, "traction", false, false, Use::no, Use::no, Use::no, Use::no, Use::required,
       "force per area, of any direction, on the part of the free surface that lies in a region"},
  });
}();
static_assert(is_in_order(boundary_kinds));

constexpr const BoundaryKind& row_of(BoundaryCase::Kind kind) {
  return boundary_kinds[static_cast<std::size_t>(kind)];
}

template <>
inline constexpr auto words<BoundaryCase::Kind> = words_of<BoundaryCase::Kind>(boundary_kinds);

}  // namespace pliant
