#include "engine/finite_elements/parameters.hpp"

namespace pliant::finite_elements {

void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  auto& method = parameters.as<Parameters>();
  visit("pressure", method.pressure,
        {.meaning = "where the pressure is evaluated", .example = R"("averaged")"});
  point_based::visit_motion_keys(visit, method.integrator, method.damping);
}

}  // namespace pliant::finite_elements
