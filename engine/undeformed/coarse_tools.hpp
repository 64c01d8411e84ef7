#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/case/checks/tools.hpp"

namespace pliant::undeformed {

/// Errors of walls that hold a part of a face, as measured for bonded punches, docs/decisions/0079.
inline constexpr NarrowToolError bonded_punches[] = {{4.1, 12}, {5.5, 8}, {8.5, 5}};

/// Warns of walls that are narrow in spacings, as measured for punches and balls that are pressed
/// into blocks and for discs that bend a beam, docs/decisions/0079 and 0085; `attached` are the
/// errors of walls that hold a body.
inline void warn_of_coarse_tools(const Case& a_case, std::span<const NarrowToolError> attached,
                                 std::vector<std::string>& warnings) {
  static constexpr NarrowToolError edged[] = {{4.1, 30}, {8.5, 13}};
  static constexpr NarrowToolError round[] = {{2, 100}, {4.1, 17}, {5.5, 10}, {8.5, 5}};
  warn_of_narrow_tools(a_case, {edged, round, attached}, warnings);
}

}  // namespace pliant::undeformed
