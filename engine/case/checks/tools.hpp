#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Deviation of the force of walls, or of what they hold, that are narrower than `across` spacings.
struct NarrowToolError {
  double across;
  int deviation;  ///< [%]
};

/// The errors of walls that meet a part of a face, each in ascending order of `across`.
struct NarrowToolErrors {
  std::span<const NarrowToolError> edged, round;  ///< contact walls
  std::span<const NarrowToolError> attached;      ///< walls that hold a body
};

/// How wide the part of a wall is that meets a body [m]. A contact wall: its diameter if it is
/// round, else the least width of its bounding box beside the body. A wall that holds the body: the
/// least length along which the boxes overlap, beside the way that the wall reaches into the body.
/// Infinite if the wall is as wide as the body, as a plate is, for walls that surround a body, and
/// for round walls that hold one.
double width_of_tool(const Case& a_case, const BoundaryCase& wall, const BodyCase& body);

/// Adds a warning for each wall that is narrow.
void warn_of_narrow_tools(const Case& a_case, const NarrowToolErrors& errors,
                          std::vector<std::string>& warnings);

/// Adds a warning for each contact wall that presses on a part of a body only; `deviation` says
/// what is wrong there.
void warn_of_tools(const Case& a_case, std::string_view deviation,
                   std::vector<std::string>& warnings);

}  // namespace pliant
