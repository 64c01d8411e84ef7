#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/word.hpp"

/// The laws of contact, one row for each: word, meaning, and what methods need to know. Tractions
/// between bodies are in kernels/interface_traction.hpp.
namespace pliant {

struct ContactLawRow {
  ContactLaw kind;
  std::string_view word;
  bool separates;  ///< whether bodies can separate
  bool of_walls;   ///< whether walls accept the word as `friction`
  bool slides;     ///< whether surfaces slide without friction
  std::string_view meaning;
};

inline constexpr auto contact_laws = std::to_array<ContactLawRow>({
    {ContactLaw::frictionless, "frictionless", true, true, true,
     "unilateral contact without friction (RP.47), (RP.56), (TL.16)"},
    {ContactLaw::no_slip, "no_slip", true, true, false,
     "unilateral contact without sliding (RP.46), (RP.56), (TL.16)"},
    {ContactLaw::tied, "tied", false, false, false,
     "permanent bond without sliding or separation (RP.56), (TL.21)"},
    {ContactLaw::coulomb, "coulomb", true, false, false,
     "unilateral contact with Coulomb friction (RP.75), (TL.16)"},
});
static_assert(is_in_order(contact_laws));

constexpr const ContactLawRow& row_of(ContactLaw law) {
  return contact_laws[static_cast<std::size_t>(law)];
}

template <>
inline constexpr auto words<ContactLaw> = words_of<ContactLaw>(contact_laws);

/// The laws that walls accept as `friction`.
inline std::vector<Word> wall_frictions() {
  std::vector<Word> list;
  for (const ContactLawRow& row : contact_laws) {
    if (row.of_walls) list.push_back(word(row.kind, row.word, row.meaning));
  }
  return list;
}

}  // namespace pliant
