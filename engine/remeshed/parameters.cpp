#include "engine/remeshed/parameters.hpp"

namespace pliant::remeshed {

void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  auto& remeshed = parameters.as<Parameters>();
  visit("gradient", remeshed.gradient,
        {.meaning = "gradients of velocity and stress", .example = R"("moment_matrix")"});
  visit("reinitialisation", remeshed.reinitialisation,
        {.meaning = "how the level set becomes a signed distance again, every "
                    "level_set.reinitialise_every steps",
         .example = R"("closest_point")"});
  visit("determinant", remeshed.determinant,
        {.meaning = "det F of remeshed particles, for materials that carry F",
         .example = R"("from_density")"});
  visit("free_motion", remeshed.free_motion,
        {.meaning = "velocity and spin of bodies that no wall, load or other body pushes",
         .example = R"("kept")"});
  visit("mass_scaling", remeshed.mass_scaling,
        {.meaning =
             "factor of the inertia, for slow loads: steps are longer by its square root (RP.87)",
         .example = "1e4",
         .limits = at_least_one});
}

}  // namespace pliant::remeshed
