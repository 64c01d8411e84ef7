#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/total_lagrangian/blocks.hpp"

// Bodies one and two cells thick bend and twist correctly, whatever Poisson's ratio.
namespace pliant::test {
namespace {

std::string elastic_body(const std::string& box, double poissons_ratio) {
  return fmt::format(R"(method = "total_lagrangian"
dimension = 3
time = {{ end = 1 }}
[[body]]
name = "body"
geometry = {{ shape = "box", {} }}
material = {{ model = "linear", youngs_modulus = 100, poissons_ratio = {}, density = 1 }}
)",
                     box, poissons_ratio);
}

/// u_a = k[a][c] x_1 x_2 x_3/x_c, summed over c, from the middle of a cube of one cell.
using Curvatures = std::array<std::array<double, 3>, 3>;

double energy_of(const Curvatures& k, double poissons_ratio) {
  LagrangianSolver<3> solver(
      tests::read_text(elastic_body("lower = [0, 0, 0], upper = [1, 1, 1]", poissons_ratio),
                       {"discretisation.spacing=1"}),
      {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  for_each_particle<3>(body, [&](std::int64_t p, const Point<3>& x) {
    for (int a = 0; a < 3; ++a) {
      body.displacement[a][p] = 0;
      for (int c = 0; c < 3; ++c) {
        const double y = x[(c + 1) % 3] - 0.5, z = x[(c + 2) % 3] - 0.5;
        body.displacement[a][p] += k[a][c] * y * z;
      }
    }
  });
  return solver.integrals().strain_energy;
}

/// (TL.18) over a cube of size 1.
double energy_of_plates(const Curvatures& k, double poissons_ratio) {
  const double e = 100, mu = e / 2 / (1 + poissons_ratio);
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    sum += 4. / 3 * mu * k[c][c] * k[c][c];
    for (int a = 0; a < c; ++a) {
      const double one = k[a][c], other = k[c][a];
      sum += e / (1 - poissons_ratio * poissons_ratio) *
             (one * one + other * other + 2 * poissons_ratio * one * other);
    }
  }
  return sum / 24;
}

TEST(total_lagrangian, a_cell_that_bends_and_twists_has_the_energy_of_plates) {
  const Curvatures beam = {{{0, 0, 1e-3}, {0, 0, 0}, {0, 0, 0}}};
  const Curvatures saddle = {{{0, 0, 1e-3}, {0, 0, 0}, {-0.3e-3, 0, 0}}};
  const Curvatures twisted_plate = {{{1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, -1e-3}}};
  const Curvatures any = {{{1e-3, -2e-3, 3e-3}, {5e-4, -1e-3, 2e-3}, {-1e-3, 4e-4, 2e-3}}};
  for (const double poissons_ratio : {0., 0.3, 0.49}) {
    for (const Curvatures& k : {beam, saddle, twisted_plate, any}) {
      const double right = energy_of_plates(k, poissons_ratio);
      // I1* - 3, about 1e-6, is a difference of numbers of size 3.
      EXPECT_NEAR(energy_of(k, poissons_ratio), right, 1e-8 * right) << poissons_ratio;
    }
  }
}

/// How far a body under a load has sunk at the end.
double deflection(const std::string& text, double end) {
  LagrangianSolver<3> solver(tests::read_text(text), {1, kernels::widest_supported()});
  advance_until(solver, end);
  return -solver.measure()[0];
}

/// Deflection of a beam of 10 x 2 x 2 under an end load of 1e-3, two cells thick.
double deflection_of_beam(double poissons_ratio) {
  return deflection(elastic_body("lower = [0, -1, -1], upper = [10, 1, 1]", poissons_ratio) +
                        R"([[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }
[[boundary]]
name = "load"
kind = "traction"
traction = [0, 0, -0.25e-3]
area = "undeformed"
geometry = { shape = "half_space", point = [9.999, 0, 0], normal = [-1, 0, 0] }
[[measurement]]
name = "tip"
kind = "point_displacement"
point = [10, 0, 0]
axis = "z"
[discretisation]
spacing = 1
[total_lagrangian]
damping = 0.4
)",
                    80);
}

// Two cells cannot resolve the edges of the clamp, where the stress is singular unless nu is 0:
// implicit finite elements with incompatible modes (C3D8I) also have an error of 1.6 %.
TEST(total_lagrangian, a_beam_of_two_cells_bends_right_for_any_poissons_ratio) {
  const double load = 1e-3, length = 10, inertia = 16. / 12, area = 4;
  const double bending = load * length * length * length / (3 * 100 * inertia);
  const double shear = load * length / (5. / 6 * area * 50);
  EXPECT_NEAR(deflection_of_beam(0) / (bending + shear), 1, 0.01);  // Timoshenko
  // Quadratic finite elements, extrapolated (bench/accuracy.toml).
  EXPECT_NEAR(deflection_of_beam(0.3) / 2.543e-3, 1, 0.02);
}

/// Deflection of the middle of a clamped plate of 1 x 1 x 0.05, one cell thick, over q L^4/D.
double deflection_of_plate(double poissons_ratio) {
  const double thickness = 0.05, load = 1e-6;
  const double rigidity = 100 * std::pow(thickness, 3) / 12 / (1 - poissons_ratio * poissons_ratio);
  const double frequency = 36 * std::sqrt(rigidity / thickness);
  const std::string text =
      elastic_body("lower = [0, 0, 0], upper = [0.5, 0.5, 0.05]", poissons_ratio) + R"([[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "union", of = [
  { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] },
  { shape = "half_space", point = [0, 0, 0], normal = [0, 1, 0] } ] }
[[boundary]]
name = "middle_x"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0.5, 0, 0], normal = [-1, 0, 0] }
[[boundary]]
name = "middle_y"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0.5, 0], normal = [0, -1, 0] }
[[boundary]]
name = "load"
kind = "traction"
area = "undeformed"
geometry = { shape = "half_space", point = [0, 0, 0.0499], normal = [0, 0, -1] }
traction = [0, 0, -1e-6]
[[measurement]]
name = "middle"
kind = "point_displacement"
point = [0.5, 0.5, 0.025]
axis = "z"
[discretisation]
spacing = 0.05
)" + fmt::format("[total_lagrangian]\ndamping = {}\n", 1.6 * frequency);
  return deflection(text, 30 / frequency) * rigidity / load;
}

// Kirchhoff's plate has 0.001265; shear adds 4.6 % (nu = 0.3, Mindlin) and, proportional to 1/(1 -
// nu), 3.2 % (nu = 0).
TEST(total_lagrangian, a_plate_of_one_cell_bends_right_for_any_poissons_ratio) {
  EXPECT_NEAR(deflection_of_plate(0.3) / (1.046 * 0.001265), 1, 0.015);
  EXPECT_NEAR(deflection_of_plate(0) / (1.032 * 0.001265), 1, 0.015);
}

}  // namespace
}  // namespace pliant::test
