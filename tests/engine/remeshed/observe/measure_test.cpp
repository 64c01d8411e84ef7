#include "engine/remeshed/observe/measure.hpp"

#include <gtest/gtest.h>

#include "engine/remeshed/observe/particle_values.hpp"
#include "engine/remeshed/observe/surface.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/spinning_disc.hpp"

namespace pliant::test {
namespace {

const Vector centre = {0.013, -0.021, 0};

/// Largest distance of the measured surface from the circle, over many directions.
double surface_error(double spacing) {
  Solver solver(spinning_disc(spacing), {1, kernels::Isa::sse2});
  const LatticeView view = solver.on_nodes()[0];
  double largest = 0;
  for (int k = 0; k < 101; ++k) {
    const double angle = 2 * pi * k / 101;
    const auto r =
        remeshed::ray_to_surface(view, centre, Vector{std::cos(angle), std::sin(angle), 0});
    EXPECT_TRUE(r);
    largest = std::max(largest, std::abs(r.value_or(0) - 1));
  }
  return largest;
}

TEST(measuring, the_surface_of_a_disc_is_found_to_fourth_order) {
  const double coarse = surface_error(0.1), fine = surface_error(0.05);
  // 3/128 h^4 times a fourth derivative of the distance, at most 3, in each direction.
  EXPECT_LT(coarse, 2 * 3.0 / 128 * 3 * 1e-4);
  EXPECT_LT(fine, coarse / 12);
}

TEST(measuring, extents_reach_to_the_surface_and_no_farther) {
  Solver solver(spinning_disc(0.05), {1, kernels::Isa::sse2});
  const LatticeView view = solver.on_nodes()[0];
  const auto all = [](const Vector&) { return true; };
  const auto upper_half = [](const Vector& x) { return x[1] > 0.5; };
  for (const int axis : {0, 1}) {
    for (const bool lower_side : {false, true}) {
      const double side = lower_side ? -1 : 1;
      const double reached = *remeshed::extent<double, 2>(view, axis, lower_side, all);
      // Between the two node lines around its farthest point the circle recedes by h^2/8.
      EXPECT_LE(side * (reached - centre[axis]), 1 + 1e-6);
      EXPECT_GE(side * (reached - centre[axis]), 1 - 0.05 * 0.05 / 8 - 1e-6);
    }
  }
  const double cut = *remeshed::extent<double, 2>(view, 0, false, upper_half) - centre[0];
  const double at_the_cut = std::sqrt(1 - std::pow(0.5 - centre[1], 2));
  EXPECT_LE(cut, at_the_cut);
  EXPECT_GE(cut, at_the_cut - 0.05);  // a node line is within h above the cut
  EXPECT_FALSE((remeshed::extent<double, 2>(view, 0, false, [](const Vector&) { return false; })));
}

/// Moves particles off their nodes, in the uniform stretch x = 1.02 X, y = 0.97 Y.
void stretch(Body& body) {
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    const Point<2> node = body.lattice.node(cell);
    const double drift[] = {0.01 * node[1], 0.02}, stretch[] = {1.02, 0.97};
    for (int a = 0; a < 2; ++a) {
      const double x = node[a] + drift[a];
      body.stage[0].get(Field::drift, a)[p] = drift[a];
      body.stage[0].get(Field::displacement, a)[p] = x - x / stretch[a] - drift[a];
    }
  });
}

TEST(measuring, linear_displacements_are_traced_to_their_starting_points) {
  Solver solver(spinning_disc(0.1), {1, kernels::Isa::sse2});
  Body& body = solver.state().bodies[0];
  stretch(body);
  const Vector start = {0.31, -0.42, 0};
  const Vector d = {remeshed::material_value<double, 2>(body, start, "displacement_x"),
                    remeshed::material_value<double, 2>(body, start, "displacement_y"), 0};
  EXPECT_NEAR(d[0], 0.02 * start[0], 1e-13);
  EXPECT_NEAR(d[1], -0.03 * start[1], 1e-13);
}

TEST(measuring, linear_displacements_have_one_strain_everywhere) {
  Solver solver(spinning_disc(0.1), {1, kernels::Isa::sse2});
  Body& body = solver.state().bodies[0];
  stretch(body);
  const LatticeView particles{body, body.population, body.stage[0]};
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    const auto strain = [&](const char* component) {
      return remeshed::strain_around<double, 2>(particles, cell, body.position(p, cell), component);
    };
    ASSERT_NEAR(strain("strain_xx"), (1.02 * 1.02 - 1) / 2, 1e-12);
    ASSERT_NEAR(strain("strain_yy"), (0.97 * 0.97 - 1) / 2, 1e-12);
    ASSERT_NEAR(strain("strain_xy"), 0, 1e-12);
  });
}

// A linear fit over 2.6 h has an error of 0.4 h^2 for each second derivative.
TEST(measuring, values_of_second_degree_are_exact_inside_bodies) {
  const Case settings = tests::read_text(R"toml(dimension = 2
discretisation = { spacing = 0.1 }
time = { end = 1 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [-1, -1], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
velocity = ["x*x - 2*x*y", "1 + y*y"]
)toml");
  const Solver solver(settings, {1, kernels::Isa::sse2});
  const Body& body = solver.state().bodies[0];
  for (const auto& [x, y] : {std::pair(0.013, -0.24), std::pair(0.35, 0.41)}) {
    const Vector at = {x, y, 0};
    EXPECT_NEAR((remeshed::material_value<double, 2>(body, at, "velocity_x")), x * x - 2 * x * y,
                1e-12);
    EXPECT_NEAR((remeshed::material_value<double, 2>(body, at, "velocity_y")), 1 + y * y, 1e-12);
  }
}

TEST(measuring, everything_that_the_cases_ask_for_has_a_value_at_the_start) {
  for (const char* name : {"compression_linear", "compression_hyperelastic", "rotating_cylinder",
                           "periodic_square", "oscillating_plate"}) {
    const Case settings = small_case(name, {});
    Solver solver(settings, {1, kernels::Isa::sse2});
    const std::vector<double> values = solver.measure();
    ASSERT_EQ(values.size(), settings.measurements.size());
    for (std::size_t m = 0; m < values.size(); ++m) {
      const bool read_from_history = settings.measurements[m].of >= 0;
      EXPECT_EQ(std::isnan(values[m]), read_from_history) << settings.measurements[m].name;
    }
  }
}

TEST(measuring, the_waves_start_without_an_error) {
  const Case settings = small_case("periodic_square", {});
  Solver solver(settings, {1, kernels::Isa::sse2});
  // The case file gives frequencies and amplitudes with 12 digits.
  EXPECT_NEAR(solver.measure()[0], 0, 1e-12);
}

TEST(measuring, between_steps_changes_no_later_answer) {
  Solver asked(spinning_disc(0.1), {1, kernels::Isa::sse2});
  Solver quiet(spinning_disc(0.1), {1, kernels::Isa::sse2});
  const double at_start = asked.integrals().kinetic_energy;
  for (int step = 0; step < 5; ++step) {
    asked.step(HUGE_VAL);
    quiet.step(HUGE_VAL);
    const double energy = asked.integrals().kinetic_energy;
    asked.look_ahead(asked.clock().time + 1e-3,
                     [&] { EXPECT_NE(asked.integrals().kinetic_energy, energy); });
    EXPECT_EQ(asked.integrals().kinetic_energy, energy);
  }
  EXPECT_NE(asked.integrals().kinetic_energy, at_start);
  EXPECT_EQ(asked.integrals().kinetic_energy, quiet.integrals().kinetic_energy);
}

}  // namespace
}  // namespace pliant::test
