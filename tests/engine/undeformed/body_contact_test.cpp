#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/whole_runs.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Contact between bodies, (TL.15) and (TL.16), in all methods on the undeformed body.
namespace pliant::test {
namespace {

struct Setting {
  std::string method;
  int dimension;
};

std::string text_of(const Setting& s) { return fmt::format("{}_{}D", s.method, s.dimension); }

/// Young's modulus 100 Pa, Poisson's ratio 0.3, waves of 11.6 m/s.
constexpr double plane_modulus = 100 / (1 - 0.3 * 0.3);

struct BodiesInContact : testing::TestWithParam<Setting> {
  TemporaryFolder folder;
  const std::string& method = GetParam().method;
  const int dimension = GetParam().dimension;

  std::string start(double end) const {
    return fmt::format(R"(method = "{}"
dimension = {}
discretisation = {{ spacing = 0.125 }}
time = {{ end = {}, step = "cfl" }}
[material.rubber]
model = "reduced_polynomial"
density = 1
coefficients = [19.2307692307692]
compressibility = 0.024
)",
                       method, dimension, end);
  }
  /// [x, y], in 3D with that z.
  std::string list(double x, double y, double z = 0) const {
    return dimension == 2 ? fmt::format("[{}, {}]", x, y) : fmt::format("[{}, {}, {}]", x, y, z);
  }
  /// From (x, y) to (x + width, y + height), in 3D 0.5 deep.
  std::string box(const std::string& name, double x, double y, double width, double height,
                  double spacing = 0.125) const {
    const std::string begin = "[[body]]\nname = \"" + name + "\"\nmaterial = \"rubber\"\n";
    if (method != "finite_elements") {
      return begin + "geometry = { shape = \"box\", lower = " + list(x, y, 0) +
             ", upper = " + list(x + width, y + height, 0.5) + " }\n";
    }
    const auto cells = [spacing](double length) {
      return static_cast<int>(std::lround(length / spacing));
    };
    const BlockMesh<3> mesh{
        {cells(width), cells(height), cells(0.5)}, {x, y, 0}, {x + width, y + height, 0.5}};
    write(mesh, folder / (name + ".vtk"));
    return begin + "geometry = { shape = \"mesh\", file = \"" +
           (folder / (name + ".vtk")).string() + "\" }\n";
  }
  std::string contact(const std::string& first, const std::string& second,
                      const std::string& kind = "kind = \"frictionless\"") const {
    return "[[contact]]\nbodies = [\"" + first + "\", \"" + second + "\"]\n" + kind + "\n";
  }
  std::string force(const std::string& axis) const {
    return measurement(
        "force_" + axis,
        "kind = \"contact_force\"\nbodies = [\"lower\", \"upper\"]\naxis = \"" + axis + "\"\n");
  }
  std::unique_ptr<pliant::Solver> solver(const std::string& text,
                                         const std::vector<std::string>& more = {}) const {
    const Case settings = tests::read_text(text, more);
    return methods().make(settings, {});
  }
};

std::vector<Setting> all_settings() {
  return {{"total_lagrangian", 2},
          {"total_lagrangian", 3},
          {"point_based", 2},
          {"point_based", 3},
          {"finite_elements", 3}};
}

INSTANTIATE_TEST_SUITE_P(methods, BodiesInContact, testing::ValuesIn(all_settings()),
                         [](const auto& info) { return text_of(info.param); });

// The lower block is wider than the upper one by nothing, and in a mesh has half its spacing.
TEST_P(BodiesInContact, pressed_together_have_the_stress_of_one_body) {
  const std::string blocks =
      start(2) + "[" + method + "]\ndamping = 8\n" + box("lower", 0, 0, 1, 0.5, 0.0625) +
      box("upper", 0, 0.5, 1, 0.5) +
      half_space("floor", "kind = \"slip_wall\"", list(0, 0), list(0, 1)) +
      half_space("plate",
                 "kind = \"slip_wall\"\ndisplacement = " +
                     tests::with(list(0, 7), "7", "\"-0.01*min(t, 1)\""),
                 list(0, 1), list(0, -1)) +
      contact("lower", "upper") + force("y") +
      measurement("below", "kind = \"material_value\"\nbody = \"lower\"\nfield = \"stress_yy\"\n" +
                               std::string("point = ") + list(0.3, 0.4, 0.2) + "\n") +
      measurement("above", "kind = \"material_value\"\nbody = \"upper\"\nfield = \"stress_yy\"\n" +
                               std::string("point = ") + list(0.7, 0.6, 0.3) + "\n");
  const auto run = solver(blocks);
  run->advance(1.5);
  const double before = values(*run)["force_y"];
  run->advance(2);
  auto found = values(*run);
  // In 3D the stress is uniaxial.
  const double stress = -0.01 * (dimension == 2 ? plane_modulus : 100);
  const double area = dimension == 2 ? 1 : 0.5;
  EXPECT_NEAR((found["force_y"] - before) / 0.5, stress * area, 0.02 * std::abs(stress) * area);
  EXPECT_NEAR(found["below"], stress, 0.05 * std::abs(stress));
  EXPECT_NEAR(found["above"], stress, 0.05 * std::abs(stress));
}

}  // namespace
}  // namespace pliant::test
