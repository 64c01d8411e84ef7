#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Faces under tractions along them: forces act behind a face, (RP.107), but it moves as if they
// acted on it, (RP.112).
namespace pliant::test {
namespace {

constexpr double shear_modulus = 100 / 2.6;

// A layer of 1 m on a fixed wall, under a traction of 1 Pa along its top.
std::string layer(int dimension, const std::string& spacing) {
  const bool plane = dimension == 2;
  return fmt::format(
      R"toml(dimension = {}
discretisation = {{ spacing = "{}", damping = "adaptive" }}
time = {{ end = 4 }}
[[body]]
name = "layer"
geometry = {{ shape = "box", lower = {}, upper = {} }}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}
[[boundary]]
name = "floor"
kind = "fixed"
geometry = {{ shape = "half_space", point = {}, normal = {} }}
[[boundary]]
name = "drag"
kind = "traction"
traction = {}
geometry = {{ shape = "box", lower = {}, upper = {} }}
[periodic]
axes = {}
lower = {}
upper = {}
[[measurement]]
name = "top"
kind = "point_displacement"
point = {}
[[measurement]]
name = "middle"
kind = "point_displacement"
point = {}
[[measurement]]
name = "stress"
kind = "point_value"
field = "stress_xy"
point = {}
)toml",
      dimension, spacing, plane ? "[-inf, 0]" : "[-inf, 0, -inf]",
      plane ? "[inf, 1]" : "[inf, 1, inf]", plane ? "[0, 0]" : "[0, 0, 0]",
      plane ? "[0, 1]" : "[0, 1, 0]", plane ? "[1, 0]" : "[1, 0, 0]",
      plane ? "[-9, 0.999]" : "[-9, 0.999, -9]", plane ? "[9, 9]" : "[9, 9, 9]",
      plane ? "[\"x\"]" : "[\"x\", \"z\"]", plane ? "[0, 0]" : "[0, 0, 0]",
      plane ? "[1, 1]" : "[1, 1, 1]", plane ? "[0.5, 1]" : "[0.5, 1, 0.5]",
      plane ? "[0.5, 0.5]" : "[0.5, 0.5, 0.5]", plane ? "[0.5, 0.9]" : "[0.5, 0.9, 0.5]");
}

template <int D>
void expect_uniform_shear(const std::string& spacing, double tolerance) {
  const Case settings = tests::read_text(layer(D, spacing));
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, settings.time.end);
  const std::vector<double> found = solver.measure();
  EXPECT_NEAR(found[0] * shear_modulus, 1, tolerance) << spacing;
  EXPECT_NEAR(found[1] * shear_modulus, 0.5, 0.5 * tolerance) << spacing;
  EXPECT_NEAR(found[2], 1, 0.1) << spacing;
}

// The top moved by 0.85 of this with 8 particles across, and by 0.93 with 16. In 3D rows of
// particles slid past each other, and energy was created.
TEST(dragged_faces, shear_a_layer_evenly) {
  expect_uniform_shear<2>("1/8", 0.03);
  expect_uniform_shear<2>("1/13", 0.03);
  expect_uniform_shear<2>("1/16", 0.02);
  expect_uniform_shear<3>("1/8", 0.04);
}

// A block of 3 m by 1 m on a fixed wall, dragged along 1 m of its top. The total Lagrangian method
// with 40 particles across moves the middle of that by 0.01473 m, with an energy of 0.006928 J/m.
// With 8, 12 and 16 across it moved by 0.79, 0.86 and 0.89 of this.
const std::string dragged_block = R"toml(discretisation = { spacing = "1/8", damping = "adaptive" }
time = { end = 5 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [3, 1] }
material = { model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "drag"
kind = "traction"
traction = [1, 0]
geometry = { shape = "box", lower = [1, 0.999], upper = [2, 9] }
[[measurement]]
name = "top"
kind = "point_displacement"
point = [1.5, 1]
[[measurement]]
name = "energy"
kind = "strain_energy"
)toml";

TEST(dragged_faces, move_where_the_load_acts_on_a_part_of_them) {
  for (const auto& [spacing, tolerance] :
       {std::pair{"1/8", 0.04}, std::pair{"1/12", 0.02}, std::pair{"1/16", 0.02}}) {
    const Case settings =
        tests::read_text(dragged_block, {fmt::format("discretisation.spacing={}", spacing)});
    Solver solver(settings, {2, kernels::widest_supported()});
    advance_until(solver, settings.time.end);
    const std::vector<double> found = solver.measure();
    EXPECT_NEAR(found[0] / 0.01473, 1, tolerance) << spacing;
    EXPECT_NEAR(found[1] / 0.006928, 1, tolerance) << spacing;
  }
}

// Measuring and frames with ghosts fill ghosts from the stress without (RP.112), and give it back.
TEST(dragged_faces, move_alike_whatever_is_measured_meanwhile) {
  const Case settings = tests::read_text(dragged_block);
  Solver plain(settings, {1, kernels::widest_supported()});
  Solver measured(settings, {1, kernels::widest_supported()});
  for (int i = 0; i < 40; ++i) {
    plain.step(HUGE_VAL);
    measured.step(HUGE_VAL);
    measured.measure();
    measured.frame({.ghosts = true, .surface = true});
  }
  const Body &one = plain.state().bodies[0], &other = measured.state().bodies[0];
  for_each(one.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    for (int a = 0; a < 2; ++a) {
      EXPECT_EQ(one.stage[0].get(Field::velocity, a)[p], other.stage[0].get(Field::velocity, a)[p]);
    }
    for (int c = 0; c < 3; ++c) EXPECT_EQ(one.stress[c].get()[p], other.stress[c].get()[p]);
  });
}

}  // namespace
}  // namespace pliant::test
