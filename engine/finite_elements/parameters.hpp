#pragma once

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/method_keys.hpp"
#include "engine/case/vocabulary/word.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::finite_elements {

/// Whether pressures are averaged at nodes or evaluated in each element.
enum class ElementPressure { averaged, plain };

/// The table [finite_elements] of a case.
struct Parameters {
  ElementPressure pressure = ElementPressure::averaged;
  point_based::Integrator integrator = point_based::Integrator::leapfrog;
  std::optional<double> damping = 0.;  ///< (PB.10) [1/s]; none: adaptive, (PB.65)
};

inline const Parameters& parameters_of(const Case& settings) {
  return settings.parameters.as<Parameters>();
}

void visit_keys(MethodKeys& visit, MethodParameters& parameters);

}  // namespace pliant::finite_elements

namespace pliant {

template <>
inline constexpr std::array words<finite_elements::ElementPressure>{
    word(finite_elements::ElementPressure::averaged, "averaged",
         "at the nodes (FE.4), against locking of nearly incompressible materials"),
    word(finite_elements::ElementPressure::plain, "plain", "in each element")};

}  // namespace pliant
