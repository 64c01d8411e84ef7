#include "engine/sph/parameters.hpp"

namespace pliant::sph {

void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  auto& sph = parameters.as<Parameters>();
  visit("artificial_viscosity", sph.artificial_viscosity,
        {.meaning = "alpha of the artificial viscosity (RP.27)",
         .example = "1",
         .limits = not_negative});
  visit("artificial_stress", sph.artificial_stress,
        {.meaning = "epsilon of the artificial stress (RP.28), which prevents the tensile "
                    "instability; 0 switches it off",
         .example = "0.3",
         .limits = not_negative});
}

}  // namespace pliant::sph
