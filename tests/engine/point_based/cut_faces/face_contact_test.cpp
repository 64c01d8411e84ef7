#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/whole_runs.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Contact of the faces of a cut, (PB.20).
namespace pliant::test {
namespace {

/// A blade that divides the block at y = 0.4375 at once.
std::string dividing_blade(int dimension) {
  const std::string edge = dimension == 2
                               ? "from = [-0.3, 0.4375]\n"
                               : "from = [-0.3, 0.4375, -0.1]\nto = [-0.3, 0.4375, 1.1]\n";
  return "[[cut]]\nname = \"blade\"\n" + edge +
         (dimension == 2 ? "path = [\"160*t\", 0]\n" : "path = [\"160*t\", 0, 0]\n") +
         "end = 0.01\n";
}

/// The block between a floor and a plate that comes down by a tenth and then moves aside.
std::string press(const std::string& contact) {
  return free_points(2) + "[point_based]\ndamping = 5\ncut_contact = " + contact + R"toml(
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "plate"
kind = "moving_wall"
geometry = { shape = "half_space", point = [0, 1], normal = [0, -1] }
displacement = ["0.05*max(0, t - 1)", "-0.1*min(t, 1)"]
[[measurement]]
name = "down"
kind = "wall_force"
boundary = "plate"
axis = "y"
[[measurement]]
name = "aside"
kind = "wall_force"
boundary = "plate"
axis = "x"
)toml";
}

struct PlateForce {
  double down, aside;
};

PlateForce mean_force(const std::string& text, double from, double until) {
  PointSolver<2> solver(tests::read_text(text, {"time.end=3"}), {1, kernels::widest_supported()});
  advance_until(solver, from);
  const PlateForce start = {solver.measure(0), solver.measure(1)};
  advance_until(solver, until);
  return {(solver.measure(0) - start.down) / (until - from),
          (solver.measure(1) - start.aside) / (until - from)};
}

// Without contact the upper half sinks into the lower one without resistance.
TEST(face_contact, lets_a_divided_block_carry_compression_like_a_whole_one) {
  const double whole = mean_force(press("0"), 0.8, 1).down;
  const double divided = mean_force(press("0") + dividing_blade(2), 0.8, 1).down;
  const double apart = mean_force(press("\"off\"") + dividing_blade(2), 0.8, 1).down;
  EXPECT_LT(whole, -5);
  EXPECT_NEAR(divided, whole, 0.05 * std::abs(whole));
  EXPECT_NEAR(apart, 0, 0.1 * std::abs(whole));
}

// A block at rest under its weight is divided horizontally: nothing should move. (When faces were
// put back against the weight in each step, they shook with a tenth of the strain energy, and four
// sweeps over them created a tenth of the work of gravity.)
TEST(face_contact, keeps_a_block_at_rest_that_is_cut_under_its_weight) {
  const std::string text = tests::with(free_points(2), "dimension = 2\n",
                                       "dimension = 2\ngravity = [0, \"-4*min(t, 1)\"]\n") +
                           R"toml([point_based]
damping = 5
cut_contact = 0.4
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[cut]]
name = "blade"
from = [-0.1, 0.53]
path = ["1.2*(t - 1.5)", 0]
start = 1.5
end = 2.5
[[measurement]]
name = "sunk"
kind = "point_displacement"
point = [0.5, 0.8]
axis = "y"
)toml";
  PointSolver<2> solver(tests::read_text(text, {"discretisation.spacing=0.04", "time.end=3"}),
                        {1, kernels::widest_supported()});
  advance_until(solver, 1.45);
  const double sunk = solver.measure(0), before = balance(solver);
  advance_until(solver, 3);
  EXPECT_NEAR(solver.measure(0), sunk, 0.02 * std::abs(sunk));
  const BodyIntegrals end = solver.integrals();
  EXPECT_LT(end.kinetic_energy, 0.01 * end.strain_energy);
  EXPECT_LT(balance(solver) - before, 0.01 * end.strain_energy);
}

// At a slip of 0.05 m, Coulomb's law determines the shear.
TEST(face_contact, slides_with_the_friction_of_coulomb) {
  for (const std::string friction : {"0", "0.1"}) {
    const PlateForce force = mean_force(press(friction) + dividing_blade(2), 2.5, 3);
    const double expected = std::stod(friction) * std::abs(force.down);
    EXPECT_NEAR(std::abs(force.aside), expected, 0.03 * std::abs(force.down)) << friction;
  }
}

const std::string colliding_halves =
    "velocity = [\"1.5*y + 0.3*(y - 0.4375)/abs(y - 0.4375)\", "
    "\"-0.5*(y - 0.4375)/abs(y - 0.4375)\"";

// Faces that are put back onto each other while they slide change the angular momentum by overlap
// times slip: here 0.6 m/s times the overlap from 1 m/s in a step of 8 ms, for a tenth of the mass.
TEST(face_contact, changes_no_momentum_and_adds_no_energy) {
  for (const std::string friction : {"0", "0.3"}) {
    const std::string contact = "[point_based]\ncut_contact = " + friction + "\n";
    PointSolver<3> solver(tests::read_text(free_points(3) + colliding_halves + ", 0]\n" + contact +
                                           dividing_blade(3)),
                          {1, kernels::widest_supported()});
    const BodyIntegrals start = solver.integrals();
    advance_until(solver, 0.4);
    const BodyIntegrals end = solver.integrals();
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(end.momentum[a], start.momentum[a], 1e-13);
      EXPECT_NEAR(end.angular_momentum[a], start.angular_momentum[a], 1e-3);
    }
    const double energy = start.kinetic_energy + start.strain_energy;
    EXPECT_LT(end.kinetic_energy + end.strain_energy, energy * (1 + 1e-3)) << friction;
  }
}

TEST(face_contact, gives_the_same_bytes_over_threads_and_after_a_restart) {
  const TemporaryFolder folder;
  const Case settings =
      tests::read_text(free_points(3) + colliding_halves + ", 0]\n" +
                           "[point_based]\ncut_contact = 0.2\n" + dividing_blade(3),
                       {"time.end=0.2", "output.every=0.06", "cut.blade.end=0.1",
                        "cut.blade.path=[\"16*t\", 0, 0]"});
  const FileContent one = result_of(settings, folder / "one", 1);
  EXPECT_EQ(result_of(settings, folder / "two", 2), one);
  EXPECT_EQ(result_of(settings, folder / "one", 2, true), one);
}

}  // namespace
}  // namespace pliant::test
