#pragma once

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/method_keys.hpp"

namespace pliant::sph {

/// The table [sph] of a case.
struct Parameters {
  double artificial_viscosity = 1;  ///< alpha of (RP.27)
  double artificial_stress = 0.3;   ///< epsilon of (RP.28)
};

inline const Parameters& parameters_of(const Case& settings) {
  return settings.parameters.as<Parameters>();
}

void visit_keys(MethodKeys& visit, MethodParameters& parameters);

}  // namespace pliant::sph
