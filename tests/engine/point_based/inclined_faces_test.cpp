#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// A block whose faces are at an angle to the lattice is pulled uniformly, between planes of
// symmetry: displacements and stresses of its corners and edges are those of its middle.
namespace pliant::test {
namespace {

constexpr double pull = 0.5, young = 100, nu = 0.3;

struct Block {
  int dimension;
  double angle, spacing;
  std::string nodes, load;

  std::string vector(double x, double y, double z) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const std::string plane = fmt::format("{:.12f}, {:.12f}", c * x - s * y, s * x + c * y);
    return dimension == 2 ? "[" + plane + "]" : fmt::format("[{}, {:.12f}]", plane, z);
  }
  std::string up_to(double x, double y, double z, double distance) const {
    return fmt::format("{{ shape = \"half_space\", point = {}, normal = {} }}",
                       vector(distance * x, distance * y, distance * z), vector(x, y, z));
  }
  std::vector<std::array<double, 3>> places() const {
    std::vector<std::array<double, 3>> all;
    for (const double x : {0., 0.5, 1.}) {
      for (const double y : {0., 0.5, 1.}) {
        if (dimension == 2) all.push_back({x, y, 0});
        for (const double z : {0., 0.5, 1.}) {
          if (dimension == 3) all.push_back({x, y, z});
        }
      }
    }
    return all;
  }

  std::string text() const {
    std::string faces = up_to(1, 0, 0, 1) + ", " + up_to(-1, 0, 0, 0) + ", " + up_to(0, 1, 0, 1) +
                        ", " + up_to(0, -1, 0, 0);
    faces += dimension == 2 ? ", { shape = \"box\", lower = [-2, -2], upper = [2, 2] }"
                            : ", { shape = \"box\", lower = [-2, -2, 0], upper = [2, 2, 1] }";
    std::string text = fmt::format(R"(method = "point_based"
dimension = {}
discretisation = {{ spacing = {} }}
time = {{ end = 3 }}
[point_based]
damping = 5
nodes = "{}"
[[body]]
name = "block"
material = {{ model = "neo_hookean", density = 1, youngs_modulus = {}, poissons_ratio = {} }}
geometry = {{ shape = "intersection", of = [{}] }}
)",
                                   dimension, spacing, nodes, young, nu, faces);
    const std::string at = vector(0, 0, 0), slip = "kind = \"slip_wall\"";
    text += half_space("x", slip, at, vector(1, 0, 0)) + half_space("y", slip, at, vector(0, 1, 0));
    if (dimension == 3) text += half_space("z", slip, at, vector(0, 0, 1));
    const double c = std::cos(angle), s = std::sin(angle);
    const std::string in_z = dimension == 2 ? "]" : ", \"0\"]";
    const auto along = [&](const std::string& size) {
      return fmt::format("[\"{}*{}*min(t, 1)\", \"{}*{}*min(t, 1)\"{}", c, size, s, size, in_z);
    };
    const std::string kind =
        load == "pressure"   ? "kind = \"pressure\"\npressure = \"-0.5*min(t, 1)\""
        : load == "traction" ? "kind = \"traction\"\ntraction = " + along("0.5")
                             : "kind = \"slip_wall\"\ndisplacement = " + along("0.005");
    text += half_space("pull", kind, vector(load == "wall" ? 1 : 0.9999, 0, 0), vector(-1, 0, 0));
    for (const auto& [x, y, z] : places()) {
      const std::string place = fmt::format("{}_{}_{}", 2 * x, 2 * y, 2 * z);
      const std::string point = "\npoint = " + vector(x, y, z);
      for (const std::string axis : {"x", "y"}) {
        text += measurement(axis + place,
                            "kind = \"point_displacement\"\naxis = \"" + axis + "\"" + point);
      }
      text += measurement("s" + place,
                          "kind = \"material_value\"\nfield = \"von_mises_stress\"" + point);
    }
    return text;
  }
};

struct Errors {
  double displacement = 0, stress = 0;
};

/// Largest errors, relative to the elongation and to the stress in the middle.
Errors errors_of(const Block& block) {
  const auto run = methods().make(tests::read_text(block.text()), {2});
  run->advance(3);
  auto found = values(*run);
  const bool is_2d = block.dimension == 2;
  const double strain = block.load == "wall" ? 0.005
                        : is_2d              ? pull / young * (1 - nu * nu)
                                             : pull / young;
  const double across = -strain * (is_2d ? nu / (1 - nu) : nu);
  const double c = std::cos(block.angle), s = std::sin(block.angle);
  Errors errors;
  for (const auto& [x, y, z] : block.places()) {
    const std::string place = fmt::format("{}_{}_{}", 2 * x, 2 * y, 2 * z);
    const double along = c * found["x" + place] + s * found["y" + place],
                 aside = -s * found["x" + place] + c * found["y" + place];
    errors.displacement = std::max(
        {errors.displacement, std::abs(along / strain - x), std::abs(aside - across * y) / strain});
    const double middle = found[is_2d ? "s1_1_0" : "s1_1_1"];
    errors.stress = std::max(errors.stress, std::abs(found["s" + place] / middle - 1));
  }
  return errors;
}

// Facets that cut off edges put loads and the forces of walls on the wrong nodes: displacements
// were off by up to 0.11 of the elongation, and stresses by up to 0.48.
TEST(inclined_faces, of_a_pulled_square_are_pulled_alike) {
  for (const std::string nodes : {"lattice", "octree"}) {
    for (const std::string load : {"pressure", "traction", "wall"}) {
      for (const double angle : {0.1, 0.35, 0.6}) {
        const Errors errors = errors_of({2, angle, 0.125, nodes, load});
        EXPECT_LT(errors.displacement, 0.01) << nodes << load << angle;
        EXPECT_LT(errors.stress, 0.03) << nodes << load << angle;
      }
    }
  }
}

TEST(inclined_faces, of_a_pulled_cube_are_pulled_alike) {
  for (const std::string nodes : {"lattice", "octree"}) {
    for (const std::string load : {"pressure", "traction"}) {
      const Errors errors = errors_of({3, 0.35, 1. / 12, nodes, load});
      EXPECT_LT(errors.displacement, 0.015) << nodes << load;
      EXPECT_LT(errors.stress, 0.03) << nodes << load;
    }
  }
}

}  // namespace
}  // namespace pliant::test
