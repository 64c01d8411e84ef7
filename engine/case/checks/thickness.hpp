#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/case/case.hpp"

namespace pliant {

/// How much figures of bodies deviate that are fewer than `across` spacings thick, as measured by
/// docs/validation/robustness.py.
struct ThinBodyError {
  double across;
  std::string_view deviation;  ///< of what, and by how much
};

/// The diameter of the largest ball inside a body, which may reach into the walls that hold it: the
/// thickness of plates, beams and shells between their free surfaces [m]; infinite without any.
double thickness(const Case& a_case, const BodyCase& body);

/// The diameter of the largest circle on a loaded part of a body's surface between walls that hold
/// it, as the hole of a collar: of all loads the least [m]; infinite without walls or loads.
double opening(const Case& a_case, const BodyCase& body);

/// A warning of each body that is thinner than what a method resolves, the next one in a new line;
/// `errors` by `across`, the least first. Empty where all are thicker.
std::string thin_body_warning(const Case& a_case, std::span<const ThinBodyError> errors);

/// The same of openings between walls.
std::string narrow_opening_warning(const Case& a_case, std::span<const ThinBodyError> errors);

}  // namespace pliant
