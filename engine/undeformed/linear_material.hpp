#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::undeformed {

/// Warns of linear materials with a logarithmic equation of state, for methods in which linear
/// materials are neo-Hookean ones, (PB.6).
inline void warn_of_equation_of_state(const Case& a_case, std::vector<std::string>& warnings) {
  for (const BodyCase& body : a_case.bodies) {
    if (body.material.model != kernels::Model::linear_logarithmic) continue;
    warnings.push_back(fmt::format(
        "the linear material of body `{}` is neo-Hookean in this method, and its "
        "equation_of_state = \"logarithmic\" has no effect; take method = \"total_lagrangian\" or "
        "\"remeshed\" for large changes of volume",
        body.name));
  }
}

}  // namespace pliant::undeformed
