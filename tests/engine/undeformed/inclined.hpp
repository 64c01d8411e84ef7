#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

/// Bodies and walls at an angle to the lattice, of one material.
namespace pliant::test::inclined {

inline constexpr double young = 1000, nu = 0.3;

inline std::string start_of_case(const std::string& method, int dimension, double spacing) {
  return fmt::format(R"(method = "{0}"
dimension = {1}
discretisation = {{ spacing = {2} }}
{0} = {{ damping = "adaptive" }}
time = {{ end = 2 }}
[material.m]
model = "neo_hookean"
density = 1
youngs_modulus = {3}
poissons_ratio = {4}
[[body]]
name = "body"
material = "m"
)",
                     method, dimension, spacing, young, nu);
}

inline std::string written(const std::vector<double>& x) {
  return fmt::format("[{}]", fmt::join(x, ", "));
}

/// A half-space of material up to the plane at `distance` from the origin along `normal`.
inline std::string up_to(const std::vector<double>& normal, double distance) {
  std::vector<double> point = normal;
  for (double& component : point) component *= distance;
  return fmt::format("{{ shape = \"half_space\", point = {}, normal = {} }}", written(point),
                     written(normal));
}

inline std::vector<double> opposite(std::vector<double> x) {
  for (double& component : x) component = -component;
  return x;
}

inline std::unique_ptr<pliant::Solver> at_rest(const std::string& text) {
  const Case settings = tests::read_text(text);
  auto solver = methods().make(settings, {});
  solver->advance(2);
  return solver;
}

inline std::string ball(int dimension, double radius) {
  return fmt::format("{{ shape = \"{}\", centre = {}, radius = {} }}",
                     dimension == 2 ? "disc" : "ball", dimension == 2 ? "[0, 0]" : "[0, 0, 0]",
                     radius);
}

inline std::string displacement_at(const std::string& name, int dimension, double r, double angle) {
  std::vector<double> point = {r * std::cos(angle), r * std::sin(angle)};
  if (dimension == 3) point.push_back(0);
  return measurement(
      name, "kind = \"point_displacement\"\naxis = \"x\"\npoint = " + written(point) + "\n");
}

}  // namespace pliant::test::inclined
