#include "engine/bench/cases.hpp"

#include <cmath>
#include <numbers>

#include "engine/case/elastic_constants.hpp"

namespace pliant::bench {

namespace {

BodyCase body(const char* name, const MaterialCase& material) {
  BodyCase body;
  body.name = name;
  body.material_as_given = material;
  body.material = elastic_constants(material);
  return body;
}

BoundaryCase piston(const char* name, double y, double speed) {
  BoundaryCase wall;
  wall.name = name;
  wall.geometry.kind = Shape::Kind::half_space;
  wall.geometry.point = {0, y, 0};
  wall.geometry.normal = {0, y > 0 ? -1.0 : 1.0, 0};
  wall.velocity[1] = Expression(speed);
  return wall;
}

}  // namespace

Case rotating_cylinder(std::int64_t particles, kernels::Weight weight) {
  Case settings;
  settings.name = "rotating_cylinder";
  settings.discretisation.spacing = std::sqrt(std::numbers::pi / static_cast<double>(particles));
  settings.discretisation.kernel = weight;
  settings.time.end = 1000;
  settings.remeshing.policy = decltype(settings.remeshing)::Policy::every;
  settings.remeshing.every = 10;

  MaterialCase material;
  material.density = 1;
  material.youngs_modulus = 100;
  material.poissons_ratio = 0.3;
  BodyCase cylinder = body("cylinder", material);
  cylinder.geometry.kind = Shape::Kind::ball;
  cylinder.geometry.radius = 1;
  cylinder.velocity = RigidRotation{{}, {0, 0, 2 * std::numbers::pi}};
  settings.bodies.push_back(cylinder);
  return settings;
}

Case spinning_ball(std::int64_t particles, kernels::Weight weight) {
  Case settings = rotating_cylinder(particles, weight);
  settings.name = "spinning_ball";
  settings.dimension = 3;
  settings.discretisation.spacing =
      std::cbrt(4 * std::numbers::pi / 3 / static_cast<double>(particles));
  settings.bodies[0].name = "ball";
  return settings;
}

Case compression(int n) {
  Case settings;
  settings.name = "compression_hyperelastic";
  settings.discretisation.spacing = 1.0 / n;
  settings.time.end = 0.02;
  settings.remeshing.policy = decltype(settings.remeshing)::Policy::adaptive;

  MaterialCase material;
  material.model = MaterialCase::Model::reduced_polynomial;
  material.density = 1;
  material.coefficients = {2.2};
  material.compressibility = 0.001;
  BodyCase block = body("block", material);
  block.geometry.lower = {-0.5, -1, 0};
  block.geometry.upper = {0.5, 1, 0};
  block.velocity = VectorExpression{Expression(0), Expression("-25*y"), Expression(0)};
  settings.bodies.push_back(block);
  settings.boundaries = {piston("upper", 1, -25), piston("lower", -1, 25)};
  return settings;
}

}  // namespace pliant::bench
