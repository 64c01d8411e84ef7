#include <gtest/gtest.h>

#include <functional>

#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "tests/engine/remeshed/spinning_disc.hpp"

// Ghosts for fields that already satisfy the boundary conditions.
namespace pliant::test {
namespace {

/// A strip of the block of the compression case, periodic along one axis, at rest.
Settings strip(const char* axis) {
  return {"discretisation.spacing=1/16", std::string("periodic.axes=[\"") + axis + "\"]",
          "periodic.lower=[-0.5, -1]", "periodic.upper=[0.5, 1]", "body.block.velocity=[0, 0]"};
}

struct Values {
  Point<2> velocity;
  std::array<double, 3> stress;  ///< xx, xy, yy
};

/// Gives the particles of a body values by a function of the place, and compares the ghosts with
/// the same function. `counts` leaves out ghosts near the ends of the period, where a field that is
/// not periodic jumps.
int expect_ghosts_follow(Solver& solver, const std::function<Values(const Point<2>&)>& field,
                         const std::function<bool(const Point<2>&)>& counts) {
  Body& body = solver.state().bodies[0];
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    const Values values = field(body.position(p, cell));
    for (int a = 0; a < 2; ++a) body.stage[0].get(Field::velocity, a)[p] = values.velocity[a];
    for (int c = 0; c < 3; ++c) body.stress[c][p] = values.stress[c];
  });
  solver.refresh_ghosts();
  int count = 0;
  for (const Kind kind : {Kind::free_ghost, Kind::wall_ghost}) {
    for_each(body.population, kind, [&](std::int64_t p, const Cell<2>& cell) {
      const Point<2> x = body.position(p, cell);
      if (!counts(x)) return;
      const Values values = field(x);
      // Fits amplify rounding by the square of their condition number, about 1e2, times fields of
      // size 10.
      for (int a = 0; a < 2; ++a) {
        EXPECT_NEAR(body.stage[0].get(Field::velocity, a)[p], values.velocity[a], 1e-10)
            << "component " << a << " at " << x[0] << ", " << x[1];
      }
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(body.stress[c][p], values.stress[c], 1e-10)
            << "component " << c << " at " << x[0] << ", " << x[1];
      }
      ++count;
    });
  }
  return count;
}

bool everywhere(const Point<2>&) { return true; }
bool far_from_ends_in_y(const Point<2>& x) { return std::abs(x[1]) < 0.75; }
bool far_from_ends_in_x(const Point<2>& x) { return std::abs(x[0]) < 0.25; }

Values stretching_strip(const Point<2>& x, double pressure) {
  const double phi = std::abs(x[0]) - 0.5;
  return {{1 + 2 * x[0] - 3 * x[1], 0.5 - x[0] + 4 * x[1]},
          {-pressure + 7 * phi, -5 * phi, 3 - 2 * x[0] + 6 * x[1]}};
}

TEST(ghosts, of_a_plane_free_surface_continue_linear_fields_without_traction) {
  Solver solver(small_case("compression_linear", strip("y") + Settings{"boundary=[]"}),
                {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>& x) { return stretching_strip(x, 0); };
  EXPECT_GE(expect_ghosts_follow(solver, field, far_from_ends_in_y), 2 * 4 * 20);
}

TEST(ghosts, of_a_loaded_surface_continue_linear_fields_with_its_pressure) {
  const std::string load = R"(boundary=[{ name = "load", kind = "pressure", pressure = 4, )"
                           R"(geometry = { shape = "box", lower = [-2, -2], upper = [2, 2] } }])";
  Solver solver(small_case("compression_linear", strip("y") + Settings{load}),
                {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>& x) { return stretching_strip(x, 4); };
  EXPECT_GE(expect_ghosts_follow(solver, field, far_from_ends_in_y), 2 * 4 * 20);
}

TEST(ghosts, of_a_plane_wall_continue_linear_fields_that_move_with_it) {
  const Settings moving = {"boundary.upper.velocity=[3, -2]", "boundary.lower.velocity=[-1, 5]"};
  Solver solver(small_case("compression_linear", strip("x") + moving), {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>& x) -> Values {
    const double d = 1 - std::abs(x[1]);
    const Point<2> wall = x[1] > 0 ? Point<2>{3, -2} : Point<2>{-1, 5};
    return {{wall[0] + 6 * d, wall[1] - 4 * d},
            {1 + 2 * x[0] - 3 * x[1], 4 - x[0] + x[1], -2 + 5 * x[0] + 3 * x[1]}};
  };
  EXPECT_GE(expect_ghosts_follow(solver, field, far_from_ends_in_x), 2 * 4 * 8);
}

TEST(ghosts, of_a_slip_wall_hold_what_it_has_and_mirror_what_changes_its_sign) {
  const std::string walls =
      R"(boundary=[{ name = "upper", kind = "slip_wall", velocity = [0, -2], )"
      R"(geometry = { shape = "half_space", point = [0, 1], normal = [0, -1] } }, )"
      R"({ name = "lower", kind = "slip_wall", )"
      R"(geometry = { shape = "half_space", point = [0, -1], normal = [0, 1] } }])";
  Solver solver(small_case("compression_linear", strip("x") + Settings{walls}),
                {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>& x) -> Values {
    const double d = 1 - std::abs(x[1]);
    const double wall = x[1] > 0 ? -2 : 0;
    return {{3 - 2 * x[0], wall + 4 * d}, {1 + 2 * x[0], 7 * d, -2 + 5 * x[0]}};
  };
  EXPECT_GE(expect_ghosts_follow(solver, field, far_from_ends_in_x), 2 * 4 * 8);
}

TEST(ghosts, of_a_round_body_continue_linear_velocities_without_stress) {
  Solver solver(spinning_disc(0.1), {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>& x) -> Values {
    return {{1 + 2 * x[0] - 3 * x[1], 0.5 - x[0] + 4 * x[1]}, {}};
  };
  EXPECT_GE(expect_ghosts_follow(solver, field, everywhere), 200);
}

TEST(ghosts, that_are_rigid_continue_rigid_motions) {
  Case settings = spinning_disc(0.1);
  settings.ghosts = GhostTreatment::rigid;
  Solver solver(settings, {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>& x) -> Values { return {{1 - 3 * x[1], 2 + 3 * x[0]}, {}}; };
  EXPECT_GE(expect_ghosts_follow(solver, field, everywhere), 200);
}

TEST(ghosts, that_average_continue_uniform_motions) {
  Case settings = spinning_disc(0.1);
  settings.ghosts = GhostTreatment::averaged;
  Solver solver(settings, {1, kernels::Isa::sse2});
  const auto field = [](const Point<2>&) -> Values { return {{1, -2}, {}}; };
  EXPECT_GE(expect_ghosts_follow(solver, field, everywhere), 200);
}

// Anywhere else, the velocity that a lasting traction corrects would carry them away.
TEST(ghosts, of_free_surfaces_stay_where_the_fit_of_positions_is) {
  Case settings = spinning_disc(0.1);
  settings.remeshing.policy = decltype(settings.remeshing)::Policy::never;
  Solver solver(settings, {1, kernels::Isa::sse2});
  for (int step = 0; step < 20; ++step) solver.step(HUGE_VAL);
  const Body& body = solver.state().bodies[0];
  int count = 0;
  for (const auto& ghosts : body.population.ghosts) {
    for (std::size_t g = 0; g < ghosts.reached_count; ++g) {
      std::array<double, 2> fit = {};
      for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
        const double c = remeshed::fit_coefficient<double, 2>(ghosts, g, k, ghosts.terms[g].linear);
        const auto i = body.population.slot_of_record[kernels::record_of(ghosts.pairs[k])];
        for (int a = 0; a < 2; ++a) fit[a] += c * body.stage[0].get(Field::drift, a)[i];
      }
      for (int a = 0; a < 2; ++a) {
        EXPECT_NEAR(body.stage[0].get(Field::drift, a)[ghosts.slot[g]], fit[a], 1e-13);
      }
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

// (RP.60): ghosts that no particle reaches and that bear no force only drift.
TEST(ghosts, deep_behind_a_wall_move_with_it) {
  const Point<2> velocity = {2, -3};
  Case settings = small_case(
      "compression_linear", {"discretisation.spacing=1/16", "body.block.velocity=[2, -3]",
                             "boundary.upper.velocity=[2, -3]", "boundary.lower.velocity=[2, -3]"});
  settings.remeshing.policy = decltype(settings.remeshing)::Policy::never;
  Solver solver(settings, {1, kernels::Isa::sse2});
  for (int step = 0; step < 10; ++step) solver.step(HUGE_VAL);
  const double time = solver.clock().time;
  const Body& body = solver.state().bodies[0];
  int drifting = 0;
  for (const auto& ghosts : body.population.ghosts) {
    for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
      if (ghosts.wall[g] < 0) continue;
      if (g >= ghosts.reached_count) ++drifting;
      for (int a = 0; a < 2; ++a) {
        EXPECT_NEAR(body.stage[0].get(Field::drift, a)[ghosts.slot[g]], velocity[a] * time, 1e-12);
      }
    }
  }
  EXPECT_GT(drifting, 2 * 16);
}

}  // namespace
}  // namespace pliant::test
