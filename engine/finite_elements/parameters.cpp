#include "engine/finite_elements/parameters.hpp"

namespace pliant::finite_elements {

void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  auto& method = parameters.as<Parameters>();
  visit("pressure", method.pressure,
        {.meaning = "where the pressure is evaluated", .example = R"("averaged")"});
  visit("integrator", method.integrator,
        {.meaning = "when the forces of a step act", .example = R"("leapfrog")"});
  visit("damping", NumberOrWord{method.damping, "adaptive", "a rate"},
        {.meaning = R"(mass-proportional damping rate (PB.10), or "adaptive" for critical damping )"
                    "of the present motion (PB.65)",
         .unit = "1/s",
         .example = "0.5",
         .limits = not_negative});
}

}  // namespace pliant::finite_elements
