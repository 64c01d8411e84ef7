#pragma once

#include <optional>

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/method_keys.hpp"

namespace pliant::total_lagrangian {

/// The table [total_lagrangian] of a case.
struct Parameters {
  std::optional<double>
      hourglass_stiffness;  ///< kappa of (TL.6); none: that of the material, (TL.17)
  std::optional<double> mass_scaling = 1.;  ///< inertia over mass; none: as `time.step` requires
  std::optional<double> damping = 0.;       ///< alpha of (TL.8) [1/s]; none: adaptive, (TL.10)
};

inline const Parameters& parameters_of(const Case& settings) {
  return settings.parameters.as<Parameters>();
}

void visit_keys(MethodKeys& visit, MethodParameters& parameters);

}  // namespace pliant::total_lagrangian
