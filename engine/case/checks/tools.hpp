#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Deviation of the force of contact walls that are narrower than `across` spacings.
struct NarrowToolError {
  double across;
  int deviation;  ///< [%]
};

/// How wide the part of a contact wall is that may press on a body [m]: its diameter if it is
/// round, else the least width of its bounding box beside the body; infinite if it is as wide as
/// the body, as a plate is, and for walls that surround a body.
double width_of_tool(const Case& a_case, const BoundaryCase& wall, const BodyCase& body);

/// Adds a warning for each contact wall that is narrow, by the errors of walls with edges or of
/// round ones, each in ascending order of `across`.
void warn_of_narrow_tools(const Case& a_case, std::span<const NarrowToolError> edged,
                          std::span<const NarrowToolError> round,
                          std::vector<std::string>& warnings);

/// Adds a warning for each contact wall that presses on a part of a body only; `deviation` says
/// what is wrong there.
void warn_of_tools(const Case& a_case, std::string_view deviation,
                   std::vector<std::string>& warnings);

}  // namespace pliant
