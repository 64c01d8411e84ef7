#include "engine/total_lagrangian/parameters.hpp"

namespace pliant::total_lagrangian {

void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  auto& method = parameters.as<Parameters>();
  visit("hourglass_stiffness", NumberOrWord{method.hourglass_stiffness, "material", "a factor"},
        {.meaning = R"(hourglass stiffness: "material" for that of beams and plates (TL.17), or )"
                    "one relative to the shear stiffness for all modes (TL.6)",
         .example = "0.8",
         .limits = {0, 2, true, true, "from 0 to 2"}});
  visit("mass_scaling", NumberOrWord{method.mass_scaling, "match_time_step", "a factor"},
        {.meaning = R"(factor of the inertial mass, or "match_time_step" for the smallest factor )"
                    "that makes time.step stable",
         .example = "1e4",
         .limits = at_least_one});
  visit(
      "damping", NumberOrWord{method.damping, "adaptive", "a rate"},
      {.meaning = R"(mass-proportional damping rate (TL.8), or "adaptive" for critical damping of )"
                  "the present motion (TL.10); by default that of [discretisation]",
       .unit = "1/s",
       .example = "0.5",
       .limits = not_negative});
}

}  // namespace pliant::total_lagrangian
