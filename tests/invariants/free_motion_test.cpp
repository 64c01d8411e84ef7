#include <gtest/gtest.h>

#include <cmath>

#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/solver.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// The momentum and the spin of free bodies, (RP.90), (RP.91).
namespace pliant::test {
namespace {

/// A square of 1 m that turns once in 4 pi s and flies.
const Settings flying_square = {
    "discretisation.spacing=0.1", "measurement=[]", "time.end=2",
    R"(body=[{ name = "square", geometry = { shape = "box", lower = [2.5, -0.5], )"
    R"(upper = [3.5, 0.5] }, material = { model = "linear", youngs_modulus = 10, )"
    R"(poissons_ratio = 0.3, density = 1 }, )"
    R"(velocity = ["0.2 - 0.5*y", "0.5*x - 1.6"] }])"};

/// A brick of 1 m by 0.8 m by 0.6 m that tumbles and flies.
const Settings flying_brick = {
    "discretisation.spacing=0.1", "measurement=[]", "time.end=1", "boundary=[]",
    R"(body=[{ name = "brick", geometry = { shape = "box", lower = [-0.5, -0.4, -0.3], )"
    R"(upper = [0.5, 0.4, 0.3] }, material = { model = "reduced_polynomial", )"
    R"(coefficients = [5], compressibility = 0.1, density = 1 }, )"
    R"(velocity = ["1 + 0.4*z - 0.9*y", "0.9*x - 0.5*z", "0.5*y - 0.4*x"] }])"};

template <int D>
struct Motion {
  Vector velocity, spin;  ///< of the mass centre; about it

  explicit Motion(remeshed::Solver<double, D>& solver) {
    const remeshed::Body<double, D>& body = solver.state().bodies[0];
    const BodyIntegrals at_origin = remeshed::integrate<double, D>(
        {body, body.population, body.stage[0]}, solver.state().boundaries, {});
    Vector centre = at_origin.first_moment;
    for (double& component : centre) component /= at_origin.mass;
    velocity = at_origin.momentum;
    for (double& component : velocity) component /= at_origin.mass;
    spin = remeshed::integrate<double, D>({body, body.population, body.stage[0]},
                                          solver.state().boundaries, centre)
               .angular_momentum;
  }
};

/// Steps until particles are on new nodes.
template <int D>
void advance_to_remeshing(remeshed::Solver<double, D>& solver) {
  const std::int64_t before = solver.clock().step, count = solver.remeshings();
  while (solver.remeshings() == count && solver.clock().step < before + 1000) solver.step(HUGE_VAL);
  ASSERT_GT(solver.remeshings(), count);
}

// Sums of some hundred terms, none larger than the sum.
constexpr double rounding_of_motion = 1e-12;

template <int D>
void keeps_its_motion(const Case& settings) {
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  const Motion<D> start(solver);
  for (int remeshing = 0; remeshing < 8; ++remeshing) {
    advance_to_remeshing(solver);
    const Motion<D> now(solver);
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(now.velocity[a], start.velocity[a], rounding_of_motion);
      EXPECT_NEAR(now.spin[a], start.spin[a], rounding_of_motion);
    }
  }
}

TEST(free_motion, a_square_keeps_its_velocity_and_its_spin_to_rounding) {
  keeps_its_motion<2>(small_case("rotating_cylinder", flying_square));
}

TEST(free_motion, a_brick_keeps_its_velocity_and_its_spin_to_rounding) {
  keeps_its_motion<3>(small_case("bouncing_ball", flying_brick));
}

// Uniform gravity has no moment about the mass centre.
TEST(free_motion, gravity_changes_the_velocity_of_a_square_and_not_its_spin) {
  Solver solver(small_case("rotating_cylinder", flying_square + Settings{"gravity=[0, -0.3]"}),
                {2, kernels::widest_supported()});
  const Motion<2> start(solver);
  for (int remeshing = 0; remeshing < 8; ++remeshing) advance_to_remeshing(solver);
  const Motion<2> now(solver);
  const double fallen = -0.3 * solver.clock().time;
  EXPECT_NEAR(now.velocity[0], start.velocity[0], rounding_of_motion);
  EXPECT_NEAR(now.velocity[1] - start.velocity[1], fallen, rounding_of_motion);
  EXPECT_NEAR(now.spin[2], start.spin[2], rounding_of_motion);
}

// Both decay by exp(-alpha t): (RP.71) acts equally on all velocities. The mean place of the
// particles, about which the body turns, is off the mass centre by some hundredths of the spacing,
// 0.1.
TEST(free_motion, damping_takes_the_velocity_and_the_spin_alike) {
  Solver solver(
      small_case("rotating_cylinder", flying_square + Settings{"discretisation.damping=0.2"}),
      {2, kernels::widest_supported()});
  const Motion<2> start(solver);
  for (int remeshing = 0; remeshing < 8; ++remeshing) advance_to_remeshing(solver);
  const Motion<2> now(solver);
  const double exponent = 0.2 * solver.clock().time, left = std::exp(-exponent);
  const double off_centre = exponent * 0.5 * 0.05 * 0.1;
  EXPECT_NEAR(now.velocity[0], left * start.velocity[0], off_centre);
  EXPECT_NEAR(now.velocity[1], left * start.velocity[1], off_centre);
  EXPECT_NEAR(now.spin[2] / start.spin[2], left, 5e-3);
}

// An off-centre impact makes a disc turn, and the disc keeps this rotation.
TEST(free_motion, a_blow_turns_a_disc) {
  Solver solver(small_case("two_discs", {"discretisation.spacing=0.1", "measurement=[]",
                                         "contact.0.kind=no_slip", "body.left.velocity=[0.5, 0.4]",
                                         "body.right.velocity=[-0.5, -0.4]"}),
                {2, kernels::widest_supported()});
  EXPECT_NEAR(Motion<2>(solver).spin[2], 0, rounding_of_motion);
  advance_until(solver, 0.5);
  advance_to_remeshing(solver);
  const double turned = Motion<2>(solver).spin[2];
  EXPECT_GT(std::abs(turned), 0.01);
  for (int remeshing = 0; remeshing < 4; ++remeshing) advance_to_remeshing(solver);
  // (RP.69) then moves particles but not the ghosts beside them, which the integrals read too; the
  // error is some thousandths of their velocity.
  EXPECT_NEAR(Motion<2>(solver).spin[2], turned, 2e-3 * std::abs(turned));
}

}  // namespace
}  // namespace pliant::test
