#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Deviation of results for bodies thinner than `across` spacings, as measured by
/// docs/validation/robustness.py.
struct ThinBodyError {
  double across;
  std::string_view deviation;  ///< which result, and by how much
};

/// The error of a body that is this many spacings thick, or null; `errors` are in ascending order
/// of `across`.
const ThinBodyError* error_at(std::span<const ThinBodyError> errors, double across);

/// The diameter of the largest ball inside a body, where walls that hold the body count as its
/// inside. For plates, beams and shells it is the thickness between the free surfaces [m]; infinite
/// without free surfaces.
double thickness(const Case& a_case, const BodyCase& body);

/// The diameter of the largest circle on a loaded part of a body's surface between walls that hold
/// it, such as the hole of a collar: the smallest for all loads [m]; infinite without walls or
/// loads.
double opening(const Case& a_case, const BodyCase& body);

/// Adds a warning for each body that `counts` selects and that is too thin for a method; `errors`
/// are in ascending order of `across`.
void warn_of_thin_bodies(
    const Case& a_case, std::span<const ThinBodyError> errors, std::vector<std::string>& warnings,
    const std::function<bool(const BodyCase&)>& counts = [](const BodyCase&) { return true; });

/// The same for openings between walls.
void warn_of_narrow_openings(const Case& a_case, std::span<const ThinBodyError> errors,
                             std::vector<std::string>& warnings);

/// Adds a warning for each body whose bending under loads deviates by more than 2 %: by `factor`
/// (L h/t^2)^2 if its length is L and its thickness t.
void warn_of_slender_bodies(const Case& a_case, double factor, std::vector<std::string>& warnings);

/// Errors of bodies that round walls hold, over (h/R)^2, R the radius of the wall.
struct RoundWallError {
  double cylinder;  ///< also a disc in 2D
  double ball;
};

/// Adds a warning for each no-slip wall whose smallest radius is so small that the deviation is
/// above 4 %.
void warn_of_round_walls(const Case& a_case, const RoundWallError& error,
                         std::vector<std::string>& warnings);

/// Adds a warning for each body whose free surface has a re-entrant corner; `deviation` says what
/// is wrong there. Bodies from meshes are left out.
void warn_of_reentrant_corners(const Case& a_case, std::string_view deviation,
                               std::vector<std::string>& warnings);

}  // namespace pliant
