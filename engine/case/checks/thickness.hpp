#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// Adds a warning of each body that is thinner than what a method resolves; `errors` by `across`,
/// the least first.
void warn_of_thin_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                         std::vector<std::string>& warnings);

/// The same of openings between walls.
void warn_of_narrow_openings(const Case& a_case, std::span<const ThinBodyError> errors,
                             std::vector<std::string>& warnings);

}  // namespace pliant
