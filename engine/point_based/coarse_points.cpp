#include "engine/point_based/coarse_points.hpp"

#include <algorithm>

#include "engine/case/checks/thickness.hpp"
#include "engine/geometry/is_round.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

namespace {

bool has_stress_measured_near_surface(const Case& a_case, const BodyCase& body) {
  constexpr double near = 1.6;  // spacings
  return std::ranges::any_of(a_case.measurements, [&](const MeasurementCase& measurement) {
    using enum MeasurementCase::Kind;
    const bool is_at_a_point =
        measurement.kind == point_value || measurement.kind == material_value;
    return is_at_a_point && measurement.field.find("stress") != std::string::npos &&
           &a_case.bodies[measurement.body] == &body &&
           signed_distance(body.geometry, measurement.point, a_case.dimension) >
               -near * a_case.discretisation.spacing;
  });
}

}  // namespace

// Thin: the cantilever of docs/validation/robustness.py. Octrees: beams of squares in 2D. Rods: of
// a length of 4 and 6 diameters between walls. Stresses: beams between walls that turn.
void warn_of_coarse_points(const Case& a_case, std::vector<std::string>& warnings) {
  static constexpr ThinBodyError thin[] = {{1.5, "two layers of nodes hardly resist bending"},
                                           {2, "bending deviates by 5 %"}};
  warn_of_thin_bodies(a_case, thin, warnings);
  static constexpr ThinBodyError octree[] = {{6.5, "it bends up to 16 % too little"},
                                             {15, "it bends up to 8 % too little"}};
  const bool has_octree = parameters_of(a_case).nodes == NodePlacement::octree;
  if (has_octree && a_case.dimension == 2) warn_of_thin_bodies(a_case, octree, warnings);
  static constexpr ThinBodyError rod[] = {
      {3.5, "where it bends or twists, forces are up to 20 % too small"},
      {5.5, "where it bends or twists, forces deviate by up to 8 %"},
      {7.5, "where it bends or twists, forces deviate by up to 4 %"}};
  if (a_case.dimension == 3) {
    warn_of_thin_bodies(a_case, rod, warnings, [](const BodyCase& body) {
      return has_round_part(body.geometry) && !has_elements(body.geometry);
    });
  }
  static constexpr ThinBodyError bent[] = {
      {4.5, "where it bends, stresses near its surface are up to 12 % too small"},
      {6.5, "where it bends, stresses near its surface are up to 7 % too small"},
      {10.5, "where it bends, stresses near its surface are up to 5 % too small"}};
  warn_of_thin_bodies(a_case, bent, warnings, [&](const BodyCase& body) {
    return has_stress_measured_near_surface(a_case, body) && !has_elements(body.geometry);
  });
}

}  // namespace pliant::point_based
