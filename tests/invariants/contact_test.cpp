#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/remeshed/contact/contact_momentum_correction.hpp"
#include "engine/remeshed/solver.hpp"
#include "tests/invariants/sample_runs.hpp"

// A disc that bounces off a wall.
namespace pliant::test {
namespace {

Case bouncing_disc(const Settings& more) {
  for (const SampleRun& run : sample_runs()) {
    if (std::string(run.name) == "contact") return small_case(run.of, run.settings + more);
  }
  return {};
}

int touching(Solver& solver) {
  solver.refresh_ghosts();
  int count = 0;
  for (const auto& ghosts : solver.state().bodies[0].population.ghosts) {
    for (const std::int32_t g : ghosts.contact) count += ghosts.active[g];
  }
  return count;
}

double momentum(Solver& solver) { return solver.integrals().momentum[1]; }

double total(Solver& solver, int axis) {
  return remeshed::budget_momentum<double, 2>(solver.state(), 0)[axis];
}

// Only the relative velocity matters.
TEST(contact, does_not_depend_on_which_of_the_two_moves) {
  std::vector<double> leaves;
  for (const double of_disc : {-1., -0.3, 0.}) {
    Solver solver(
        bouncing_disc({"body.ball.velocity=[0, " + std::to_string(of_disc) + "]",
                       "boundary.wall.velocity=[0, " + std::to_string(1 + of_disc) + "]"}),
        {2, kernels::widest_supported()});
    const double start = momentum(solver), mass = solver.integrals().mass;
    advance_until(solver, 0.3);
    leaves.push_back((momentum(solver) - start) / mass - 1);
  }
  EXPECT_GT(leaves[0], 0.7);
  EXPECT_NEAR(leaves[1], leaves[0], 0.003);
  EXPECT_NEAR(leaves[2], leaves[0], 0.003);
}

// The impulse is the traction on the wall, the momentum an integral over the body: two independent
// sums. The contact patch grows by whole slots of h, a tenth of it when it is largest.
TEST(contact, the_impulse_of_the_wall_is_the_change_of_momentum) {
  for (const char* friction : {"frictionless", "no_slip"}) {
    Solver solver(bouncing_disc({std::string("boundary.wall.friction=") + friction}),
                  {2, kernels::widest_supported()});
    const double start = momentum(solver);
    advance_until(solver, 0.05);
    EXPECT_GT(touching(solver), 10);
    const double pressed = momentum(solver);
    EXPECT_NEAR(solver.state().wall_impulse[0].force[1] / (pressed - start), 1, 0.03) << friction;
    advance_until(solver, 0.3);
    EXPECT_EQ(touching(solver), 0) << "it has left the wall";
    EXPECT_GT(momentum(solver), -0.7 * start);
    EXPECT_LT(momentum(solver), -start) << "a wall at rest gives no energy";
    EXPECT_NEAR(solver.state().wall_impulse[0].force[1] / (momentum(solver) - start), 1, 0.03)
        << friction;
  }
}

// The impulse is a sum over ghosts of two layers in all stages of a step, the map is one layer at
// one time. Pressure at the edge of contact differs between layers: one slot in ten along a side.
TEST(contact, the_map_of_the_pressure_adds_up_to_the_force) {
  for (const char* friction : {"frictionless", "no_slip"}) {
    Solver solver(bouncing_disc({std::string("boundary.wall.friction=") + friction}),
                  {2, kernels::widest_supported()});
    advance_until(solver, 0.05);
    const Frame frame = solver.frame({.ghosts = true});
    const auto field = std::ranges::find(frame.fields, "wall_pressure", &FrameField::name);
    ASSERT_NE(field, frame.fields.end());
    const auto& pressure = std::get<std::vector<double>>(field->values);
    const double sum = std::accumulate(pressure.begin(), pressure.end(), 0.);
    const double before = solver.state().wall_impulse[0].force[1], t = solver.clock().time;
    solver.step(1e-4);
    const double force =
        (solver.state().wall_impulse[0].force[1] - before) / (solver.clock().time - t);
    EXPECT_NEAR(sum * solver.state().bodies[0].lattice.spacing / force, 1, 0.05) << friction;
  }
}

// (RP.52): in every stage.
TEST(contact, the_wall_never_pulls) {
  for (const char* friction : {"frictionless", "no_slip"}) {
    Solver solver(bouncing_disc({std::string("boundary.wall.friction=") + friction}),
                  {2, kernels::widest_supported()});
    double before = 0;
    while (solver.clock().time < 0.25) {
      solver.step(1e-2);
      const double impulse = solver.state().wall_impulse[0].force[1];
      EXPECT_GE(impulse, before) << friction << ", t = " << solver.clock().time;
      before = impulse;
    }
    EXPECT_EQ(touching(solver), 0) << "it has left the wall";
  }
}

// The level set ends at the wall, (RP.54): the body neither enters it nor leaves a gap.
TEST(contact, the_surface_lies_on_the_wall_where_it_touches) {
  Solver solver(bouncing_disc({}), {2, kernels::widest_supported()});
  advance_until(solver, 0.05);
  const Body& body = solver.state().bodies[0];
  const double h = body.lattice.spacing;
  for (const auto& ghosts : body.population.ghosts) {
    for (std::size_t k = 0; k < ghosts.contact.size(); ++k) {
      if (ghosts.active[ghosts.contact[k]] == 0) continue;
      EXPECT_GT(ghosts.contact_height[k], -0.02 * h);
      EXPECT_LT(ghosts.contact_height[k], 0.3 * h);
    }
  }
}

// In the middle, where no fit is singular and needs a larger radius: 2.6 h up and 1.73 h to the
// sides.
TEST(contact, fits_at_the_wall_look_farther_into_the_body_than_along_it) {
  Solver solver(bouncing_disc({}), {2, kernels::widest_supported()});
  advance_until(solver, 0.05);
  const Body& body = solver.state().bodies[0];
  const double h = body.lattice.spacing;
  double highest = 0, widest = 0;
  for (const auto& ghosts : body.population.ghosts) {
    for (const std::int32_t g : ghosts.contact) {
      const auto& foot = ghosts.foot[g];
      if (std::abs(foot[0]) > 3 * h) continue;
      for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
        const auto slot = body.population.slot_of_record[kernels::record_of(ghosts.pairs[k])];
        const auto x = body.lattice.node(body.population.layout.cell(slot));
        widest = std::max(widest, std::abs(x[0] - foot[0]));
        highest = std::max(highest, x[1] - foot[1]);
      }
    }
  }
  EXPECT_LT(widest, 1.74 * h);
  EXPECT_GT(highest, 1.5 * h);
}

// A frictionless wall exerts no force along itself, whatever its orientation: here 30 degrees.
TEST(contact, an_oblique_impact_without_friction_keeps_the_momentum_along_the_wall) {
  const double sine = 0.5, cosine = std::sqrt(0.75);
  const std::string wall =
      "boundary.wall.geometry={ shape = \"half_space\", point = [-0.14, 0.0375129], normal = "
      "[0.5, 0.8660254037844386] }";
  Solver solver(bouncing_disc({wall, "discretisation.spacing=0.036", "remeshing.every=10",
                               "time.step=2e-3", "body.ball.velocity=[-0.1, -1]"}),
                {1, kernels::widest_supported()});
  const auto along = [&] { return cosine * total(solver, 0) - sine * total(solver, 1); };
  const auto towards = [&] { return -sine * total(solver, 0) - cosine * total(solver, 1); };
  const double start = along(), speed = towards();
  advance_until(solver, 0.3);
  EXPECT_EQ(touching(solver), 0) << "it has left the wall";
  EXPECT_LT(towards(), -0.7 * speed);
  EXPECT_NEAR(along(), start, 1e-12 * start);
}

// (RP.98), whatever the orientation of the wall: while the body slides, its budget has the impulse
// that the wall reports.
TEST(contact, an_oblique_impact_takes_the_momentum_that_sliding_friction_reports) {
  const double sine = 0.5, cosine = std::sqrt(0.75);
  const std::string wall =
      "boundary.wall.geometry={ shape = \"half_space\", point = [-0.14, 0.0375129], normal = "
      "[0.5, 0.8660254037844386] }";
  Solver solver(
      bouncing_disc({wall, "boundary.wall.friction=0.1", "discretisation.spacing=0.036",
                     "remeshing.every=10", "time.step=2e-3", "body.ball.velocity=[1.432, -1.52]"}),
      {1, kernels::widest_supported()});
  const auto along = [&] { return cosine * total(solver, 0) - sine * total(solver, 1); };
  const double start = along();
  advance_until(solver, 0.3);
  EXPECT_EQ(touching(solver), 0) << "it has left the wall";
  const auto& impulse = solver.state().wall_impulse[0].force;
  EXPECT_LT(along(), 0.98 * start);
  EXPECT_NEAR(along() - start, cosine * impulse[0] - sine * impulse[1], 1e-12 * start);
}

// From 1 m/s, for 0.2 s: Coulomb's law leaves 1 m/s - 0.2 s mu g, if the weight of the block rests
// on the wall, onto which it drops at t = 0 and vibrates. Occasionally a slot sticks for one step.
// The loss of energy is that of friction, (RP.99).
TEST(contact, a_block_that_slides_on_a_floor_is_slowed_by_its_friction) {
  for (const char* spacing : {"0.04", "0.025"}) {
    for (const double friction : {0.1, 0.3}) {
      Solver solver(
          bouncing_disc(
              {"gravity=[0, -10]", std::string("discretisation.spacing=") + spacing,
               "time.step=2e-3", "body.ball.velocity=[1, 0]",
               "body.ball.geometry={ shape = \"box\", lower = [0, 0], upper = [0.2, 0.2] }",
               "measurement=[]", "boundary.wall.friction=" + std::to_string(friction)}),
          {1, kernels::widest_supported()});
      const double start = total(solver, 0);
      advance_until(solver, 0.2);
      const double speed = total(solver, 0) / start;
      const auto& impulse = solver.state().wall_impulse[0].force;
      EXPECT_NEAR(speed - 1, impulse[0] / start, 0.005) << spacing << ", " << friction;
      EXPECT_NEAR(speed, 1 - 2 * friction, 0.03) << spacing << ", " << friction;
      EXPECT_NEAR(solver.state().energy.friction / (start / 2), 1 - speed * speed, 0.1)
          << spacing << ", " << friction;
    }
  }
}

// Coulomb's law on an incline of 30 degrees: a = g (sin - mu cos), or rest.
TEST(contact, a_block_slides_down_an_incline_as_friction_lets_it) {
  const double sine = 0.5, cosine = std::sqrt(0.75);
  for (const double friction : {0., 0.3, 0.8}) {
    Solver solver(
        bouncing_disc({"gravity=[0.5, -0.8660254037844386]", "discretisation.spacing=0.05",
                       "time.step=1e-3", "remeshing.every=10", "body.ball.velocity=[0, 0]",
                       "body.ball.geometry={ shape = \"box\", lower = [0, 0], upper = [0.8, 0.3] }",
                       "measurement=[]", "boundary.wall.friction=" + std::to_string(friction)}),
        {1, kernels::widest_supported()});
    advance_until(solver, 0.6);
    const double mass = 0.24, weight = mass * cosine;
    const double expected = std::max(0., sine - friction * cosine) * 0.6;
    EXPECT_NEAR(total(solver, 0) / mass, expected, 0.02) << friction;
    const auto& impulse = solver.state().wall_impulse[0].force;
    EXPECT_NEAR(impulse[1], 0.6 * weight, 0.05 * weight) << friction;
    EXPECT_LE(-impulse[0], (friction + 1e-12) * impulse[1]) << "within the cone of friction";
  }
}

// A disc that hits a rigid one head-on, which is at rest or approaches with half the speed: only
// the relative velocity matters.
TEST(contact, a_round_wall_that_moves_gives_the_momentum_that_it_counts) {
  for (const double speed : {0., 0.5}) {
    const std::string up = std::to_string(speed);
    Solver solver(
        bouncing_disc(
            {"discretisation.spacing=0.036", "time.step=1e-3", "remeshing.every=10",
             "boundary.wall.velocity=[0, " + up + "]",
             "body.ball.velocity=[0, " + std::to_string(speed - 1) + "]",
             "boundary.wall.geometry={ shape = \"disc\", centre = [0, -0.51], radius = 0.5 }"}),
        {1, kernels::widest_supported()});
    const double start = total(solver, 1), mass = start / (speed - 1);
    advance_until(solver, 0.4);
    EXPECT_EQ(touching(solver), 0) << "it has left the wall";
    const double gained = total(solver, 1) - start;
    EXPECT_GT(gained, 1.7 * mass);
    EXPECT_LT(gained, 2 * mass) << "a rigid wall gives no energy";
    EXPECT_NEAR(solver.state().wall_impulse[0].force[1] / gained, 1, 0.06);
  }
}

TEST(contact, no_particle_lies_beyond_the_wall) {
  Solver solver(bouncing_disc({}), {2, kernels::widest_supported()});
  advance_until(solver, 0.05);
  const Body& body = solver.state().bodies[0];
  for_each(body.population, Kind::interior, [&](std::int64_t slot, const Cell<2>& cell) {
    EXPECT_GT(body.position(slot, cell)[1], -0.1 * body.lattice.spacing);
  });
}

TEST(contact, a_disc_that_flies_away_feels_no_wall) {
  Solver solver(bouncing_disc({"body.ball.velocity=[0, 1]"}), {2, kernels::widest_supported()});
  advance_until(solver, 0.05);
  EXPECT_EQ(solver.state().wall_impulse[0].force[1], 0);
  EXPECT_EQ(touching(solver), 0);
}

}  // namespace
}  // namespace pliant::test
