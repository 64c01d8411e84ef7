#include "engine/point_based/parameters.hpp"

#include <algorithm>

namespace pliant::point_based {

int neighbour_count(const Case& settings) {
  const int given = parameters_of(settings).neighbours;
  if (given > 0) return given;
  const bool is_flat_octree =
      settings.dimension == 2 && parameters_of(settings).nodes == NodePlacement::octree;
  return is_flat_octree ? 12 : nodes_around(settings.dimension);
}

bool has_cuts(const Case& settings, const BodyCase& body) {
  const auto number = &body - settings.bodies.data();
  return std::any_of(settings.cuts.begin(), settings.cuts.end(),
                     [number](const CutCase& cut) { return cut.body == number; });
}

void visit_motion_keys(MethodKeys& visit, Integrator& integrator, std::optional<double>& damping) {
  visit("integrator", integrator,
        {.meaning = "when the forces of a step act", .example = R"("leapfrog")"});
  visit("damping", NumberOrWord{damping, "adaptive", "a rate"},
        {.meaning = R"(mass-proportional damping rate (PB.10), or "adaptive" for critical damping )"
                    "of the present motion (PB.65); by default that of [discretisation]",
         .unit = "1/s",
         .example = "0.5",
         .limits = not_negative});
}

void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  auto& method = parameters.as<Parameters>();
  visit("nodes", method.nodes,
        {.meaning = "positions of the nodes of a body whose geometry is not a mesh of tetrahedra",
         .example = R"("lattice")"});
  visit(
      "coarsest_spacing", method.coarsest_spacing,
      {.meaning = "largest distance between the nodes of an octree; 0 takes four times the spacing",
       .unit = "m",
       .example = "0.01",
       .limits = not_negative});
  visit("cut_rule", method.cut_rule,
        {.meaning = "weights of the bonds that a cut crosses", .example = R"("visibility")"});
  visit("cut_contact", NumberOrWord{method.cut_contact, "off", "a coefficient of friction"},
        {.meaning =
             R"(coefficient of friction between the faces of a cut (PB.20), or "off": they pass )"
             "through each other",
         .example = "0.1",
         .limits = not_negative});
  visit("gradient", method.gradient,
        {.meaning = "deformation gradient of a node", .example = R"("moving_least_squares")"});
  visit(
      "neighbours", method.neighbours,
      {.meaning = "neighbours of each node (PB.2); 0 takes 26 in 3D, 8 in 2D, and 12 in 2D octrees",
       .example = "26",
       .limits = {0, 64, true, true, "from 0 to 64"}});
  visit("stabilisation", NumberOrWord{method.stabilisation, "automatic", "a number"},
        {.meaning = R"(alpha of (PB.5), or "automatic": 0.1 on lattices, 0.2 in meshes, 0.3 in )"
                    "octrees",
         .example = "0.1",
         .limits = {0, 2, true, true, "from 0 to 2"}});
  visit_motion_keys(visit, method.integrator, method.damping);
  visit("stiffness_damping", method.stiffness_damping,
        {.meaning = "stiffness-proportional damping time (PB.9), which damps high frequencies most",
         .unit = "s",
         .example = "1e-4",
         .limits = not_negative});
}

}  // namespace pliant::point_based
