#include "engine/remeshed/setup/setup.hpp"
#include "engine/method/initial_velocity.hpp"

#include <gtest/gtest.h>

#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

using remeshed::body_lattice;

TEST(setup, surfaces_of_a_box_lie_half_way_between_nodes) {
  for (const char* spacing : {"1/16", "1/15", "1/7"}) {
    const Case settings =
        small_case("compression_linear", {std::string("discretisation.spacing=") + spacing});
    const Lattice<2> lattice = body_lattice<2>(settings, settings.bodies[0]);
    const double from_edge[] = {(0.5 + lattice.origin[0]) / lattice.spacing,
                                (1 + lattice.origin[1]) / lattice.spacing};
    for (const double cells : from_edge) EXPECT_NEAR(cells, std::round(cells), 1e-12) << spacing;
  }
}

TEST(setup, periodic_lattices_begin_at_the_cell_and_repeat_with_it) {
  const Case settings = small_case(
      "periodic_square",
      {"periodic.lower=[-0.3, 0.1]", "periodic.upper=[0.7, 1.1]",
       R"(body.medium.geometry={ shape = "box", lower = [-0.3, 0.1], upper = [0.7, 1.1] })",
       "discretisation.spacing=1/20"});
  const Lattice<2> lattice = body_lattice<2>(settings, settings.bodies[0]);
  EXPECT_EQ(lattice.origin, (Point<2>{-0.3, 0.1}));
  EXPECT_EQ(lattice.period, (Cell<2>{20, 20}));
}

TEST(setup, a_rigid_rotation_turns_about_its_centre) {
  BodyCase body;
  body.velocity.rotation = RigidRotation{{1, 2, 0}, {0, 0, 3}};
  const Vector u = initial_velocity(body, {1.5, 2.25, 0});
  EXPECT_EQ(u, (Vector{-0.75, 1.5, 0}));
}

TEST(setup, velocity_and_rotation_add_up) {
  BodyCase body;
  body.velocity.rotation = RigidRotation{{1, 2, 0}, {0, 0, 3}};
  body.velocity.translation = {Expression("2*x"), Expression(-1.0), Expression(0.0)};
  EXPECT_EQ(initial_velocity(body, {1.5, 2.25, 0}), (Vector{2.25, 0.5, 0}));
}

TEST(setup, a_fresh_solver_fills_the_body_with_particles_at_its_density) {
  const Solver solver(small_case("compression_linear", {"discretisation.spacing=1/16"}),
                      {1, kernels::Isa::sse2});
  EXPECT_EQ(solver.particles(), 16 * 32);
  const Body& body = solver.state().bodies[0];
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    const Point<2> x = body.position(p, cell);
    EXPECT_LT(std::abs(x[0]), 0.5);
    EXPECT_LT(std::abs(x[1]), 1);
    EXPECT_EQ(body.stage[0].get(Field::volume)[p], 1.0 / 256);
    EXPECT_EQ(body.stage[0].get(Field::mass)[p], 1.0 / 256);
    EXPECT_EQ(body.stage[0].get(Field::velocity, 1)[p], -25 * x[1]);
    // The free surface continues through the pistons: it consists of the flanks alone.
    EXPECT_NEAR(body.stage[0].get(Field::level_set)[p], std::max(std::abs(x[0]) - 0.5, -6.5 / 16),
                1e-15);
  });
}

}  // namespace
}  // namespace pliant::test
