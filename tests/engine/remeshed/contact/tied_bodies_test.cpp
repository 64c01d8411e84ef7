#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Bodies that are tied behave as one body, for as long as they are.
namespace pliant::test {
namespace {

std::string part(const std::string& name, const std::string& lower, const std::string& upper,
                 const std::string& rest = {}) {
  return "[[body]]\nname = \"" + name +
         "\"\nmaterial = { model = \"linear\", youngs_modulus = 1000, poissons_ratio = 0.3, "
         "density "
         "= 1 }\ngeometry = { shape = \"box\", lower = " +
         lower + ", upper = " + upper + " }\n" + rest;
}

const std::string joint = "[[contact]]\nbodies = [\"one\", \"two\"]\nkind = \"tied\"\n";

// Without a force that closes what has parted, the upper block sank by 0.024, 0.051 and 0.119 m
// after 3, 6 and 12 s. The total Lagrangian method gives 0.00887 and 0.00269 m.
TEST(tied_bodies, at_rest_do_not_part) {
  for (const std::string gap : {"0", "0.0125"}) {
    const Case settings = tests::read_text(
        "gravity = [\"0.1*min(t/2, 1)\", \"-5*min(t/2, 1)\"]\n"
        "discretisation = { spacing = 0.125, damping = \"adaptive\" }\ntime.end = 6\n" +
        part("one", "[0, 0]", "[1, 1]") + part("two", "[0, \"1 + " + gap + "\"]", "[1, 2]") +
        joint + half_space("floor", "kind = \"fixed\"", "[0, 0]", "[0, 1]") +
        measurement("x", "kind = \"point_displacement\"\nbody = \"two\"\npoint = [0.5, 1.9]") +
        measurement("y",
                    "kind = \"point_displacement\"\nbody = \"two\"\npoint = [0.5, 1.9]\n"
                    "axis = \"y\""));
    Solver solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 4);
    const double early = solver.measure()[1];
    advance_until(solver, settings.time.end);
    const std::vector<double> late = solver.measure();
    EXPECT_NEAR(late[1], -0.00887, 0.06 * 0.00887) << gap;
    EXPECT_NEAR(late[0], 0.00269, 0.16 * 0.00269) << gap;
    EXPECT_NEAR(late[1] / early, 1, 0.01) << gap;
  }
}

// The stress is uniform, but at the ends of the joint the remeshed method finds 0.79 of it.
TEST(tied_bodies, are_warned_of_where_their_joint_ends) {
  const std::string stress = "kind = \"material_value\"\nfield = \"stress_yy\"\nbody = \"one\"\n";
  const Case settings = tests::read_text(
      "discretisation = { spacing = 0.125, damping = \"adaptive\" }\ntime.end = 6\n" +
      part("one", "[0, 0]", "[2, 1]") + part("two", "[0, 1]", "[2, 2]") + joint +
      half_space("floor", "kind = \"slip_wall\"", "[0, 0]", "[0, 1]") +
      half_space("side", "kind = \"slip_wall\"", "[0, 0]", "[1, 0]") +
      half_space("top", "kind = \"slip_wall\"\ndisplacement = [0, \"0.01*min(t/2, 1)\"]", "[0, 2]",
                 "[0, -1]") +
      measurement("middle", stress + "point = [1, 1]") +
      measurement("end", stress + "point = [2, 1]"));
  const std::vector<std::string> warnings = warnings_of_method(settings);
  EXPECT_EQ(std::ranges::count_if(warnings,
                                  [](const std::string& one) {
                                    return one.find("where a joint of tied bodies ends") == 0;
                                  }),
            1);
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, settings.time.end);
  const std::vector<double> found = solver.measure();
  EXPECT_NEAR(found[1] / found[0], 0.79, 0.02);
}

// Remeshings while they bent put the joint at an angle to the lattice, and the run was stopped. The
// total Lagrangian method gives 0.1521 m and 0.0408 J.
TEST(tied_bodies, bend_far_as_one_body) {
  const Case settings = tests::read_text(
      "gravity = [5, -10]\ndiscretisation = { spacing = \"1/16\", damping = \"adaptive\" }\n"
      "time.end = 1.6\n" +
      part("one", "[0, 0]", "[1, 1]") + part("two", "[0, 1]", "[1, 2]") + joint +
      half_space("floor", "kind = \"fixed\"", "[0, 0]", "[0, 1]") +
      measurement("x", "kind = \"point_displacement\"\nbody = \"two\"\npoint = [0.5, 2]") +
      measurement("energy", "kind = \"strain_energy\"\nbody = \"two\""));
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, settings.time.end);
  const std::vector<double> found = solver.measure();
  EXPECT_NEAR(found[0], 0.1521, 0.03 * 0.1521);
  EXPECT_NEAR(found[1], 0.0408, 0.05 * 0.0408);
}

// Two halves of a clamped beam that swings. The run used to be stopped after less than a period.
TEST(tied_bodies, swing_as_one_body) {
  const std::string swing = "velocity = [0, \"0.0032*x^2\"]\n";
  const Case settings = tests::read_text(
      "discretisation.spacing = 0.125\ntime.end = 7.5\n" +
      part("one", "[0, 0]", "[2.5, 1]", swing) + part("two", "[2.5, 0]", "[5, 1]", swing) + joint +
      half_space("clamp", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
      measurement("tip",
                  "kind = \"point_displacement\"\nbody = \"two\"\npoint = [4.9, 0.6]\n"
                  "axis = \"y\"") +
      measurement("one", "kind = \"total_energy\"\nbody = \"one\"") +
      measurement("two", "kind = \"total_energy\"\nbody = \"two\""));
  Solver solver(settings, {1, kernels::widest_supported()});
  const auto energy = [&] {
    const std::vector<double> now = solver.measure();
    return now[1] + now[2];
  };
  const double start = energy();
  // The tip passes its place at rest upwards after each period.
  std::vector<double> passed;
  double before = 0, time = 0;
  for (int sample = 1; sample <= 150; ++sample) {
    advance_until(solver, 0.05 * sample);
    const double tip = solver.measure()[0];
    if (before < 0 && tip >= 0) {
      const double share = -before / (tip - before);
      passed.push_back(time + share * (solver.clock().time - time));
    }
    before = tip;
    time = solver.clock().time;
  }
  ASSERT_EQ(passed.size(), 1u);
  EXPECT_NEAR(passed[0], 4.80, 0.05);
  EXPECT_NEAR(energy() / start, 1, 0.05);
}

}  // namespace
}  // namespace pliant::test
