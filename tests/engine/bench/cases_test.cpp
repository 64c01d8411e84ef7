#include "engine/bench/cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "engine/bench/growth.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::test {
namespace {

using kernels::Kernel;

TEST(bench_cases, have_the_spacing_of_the_particles_asked_for) {
  const double pi = std::acos(-1.0);
  EXPECT_DOUBLE_EQ(bench::rotating_cylinder(2000, Kernel::compact).discretisation.spacing,
                   std::sqrt(pi / 2000));
  EXPECT_DOUBLE_EQ(bench::spinning_ball(100'000, Kernel::compact).discretisation.spacing,
                   std::cbrt(4 * pi / 3 / 100'000));
  EXPECT_DOUBLE_EQ(bench::compression(64, Kernel::compact).discretisation.spacing, 1. / 64);
}

// The settings with which rates of earlier versions were measured.
TEST(bench_cases, keep_the_settings_that_rates_depend_on) {
  using Policy = decltype(Case::remeshing)::Policy;
  for (const Case& a_case :
       {bench::rotating_cylinder(2000, Kernel::compact),
        bench::spinning_ball(2000, Kernel::compact), bench::compression(64, Kernel::compact)}) {
    EXPECT_EQ(a_case.discretisation.kernel, Kernel::compact) << a_case.name;
    EXPECT_EQ(a_case.discretisation.dissipation.velocity, 0.25) << a_case.name;
    EXPECT_EQ(a_case.discretisation.dissipation.stress, 0.25) << a_case.name;
    EXPECT_EQ(a_case.remeshing.filter, 0.2) << a_case.name;
    EXPECT_FALSE(a_case.time.step) << a_case.name;
    EXPECT_EQ(a_case.time.cfl, 0.5) << a_case.name;
    EXPECT_TRUE(a_case.measurements.empty()) << a_case.name;
    EXPECT_EQ(a_case.level_set.reinitialise_every, 20) << a_case.name;
    const bool compressed = a_case.boundaries.size() == 2;
    EXPECT_EQ(a_case.remeshing.policy, compressed ? Policy::adaptive : Policy::every);
    EXPECT_EQ(a_case.remeshing.every, 10) << a_case.name;
    EXPECT_EQ(a_case.time.end, compressed ? 0.02 : 1000) << a_case.name;
  }
}

TEST(bench_cases, a_block_of_points_has_the_nodes_asked_for_and_no_cut) {
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    const Case block = bench::point_block(8000, precision);
    EXPECT_EQ(block.method, "point_based");
    EXPECT_EQ(block.precision, precision);
    EXPECT_TRUE(block.cuts.empty());
    EXPECT_NEAR(std::pow(block.discretisation.spacing, 3) * 8000, 1.44e-4, 1e-12);
  }
}

TEST(bench_cases, an_elastic_block_has_about_the_particles_asked_for) {
  for (const int dimension : {2, 3}) {
    const Case block = bench::elastic_block(dimension, 100'000, Precision::binary32);
    EXPECT_EQ(block.method, "total_lagrangian");
    EXPECT_EQ(block.dimension, dimension);
    EXPECT_EQ(block.precision, Precision::binary32);
    const double to_a_side = 1 / block.discretisation.spacing + 1;
    EXPECT_NEAR(std::pow(to_a_side, dimension), 100'000, 5'000);
  }
}

TEST(bench_growth, has_each_method_in_both_dimensions_up_to_the_largest_size) {
  const std::vector<bench::Row> rows = bench::growth_rows(100'000, 2);
  std::map<std::pair<std::string, int>, int> sizes;
  std::set<std::string> names;
  for (const bench::Row& row : rows) {
    ++sizes[{row.settings.method, row.settings.dimension}];
    names.insert(row.name());
  }
  EXPECT_EQ(names.size(), rows.size());
  for (const int dimension : {2, 3}) {
    EXPECT_EQ((sizes[{"remeshed", dimension}]), 2) << dimension;
    EXPECT_EQ((sizes[{"total_lagrangian", dimension}]), 4) << dimension;  // in both precisions
    EXPECT_EQ((sizes[{"point_based", dimension}]), 4) << dimension;
  }
}

// 880 bytes: 1.8 slots of 57 values, and the records of surface particles.
TEST(bench_cases, a_ball_of_100_000_particles_takes_less_than_900_bytes_for_each) {
  const auto solver = methods().make(bench::spinning_ball(100'000, Kernel::compact), {});
  const auto particles = static_cast<double>(solver->particles());
  EXPECT_NEAR(particles, 105'000, 5000);
  EXPECT_LT(static_cast<double>(solver->bytes()) / particles, 900);
}

TEST(bench_cases, a_ball_spins_about_z) {
  const Case ball = bench::spinning_ball(2000, Kernel::quartic_spline);
  EXPECT_EQ(ball.dimension, 3);
  EXPECT_EQ(ball.bodies[0].name, "ball");
  EXPECT_EQ(ball.bodies[0].geometry.kind, Shape::Kind::ball);
  const auto& rotation = *ball.bodies[0].velocity.rotation;
  EXPECT_EQ(rotation.angular_velocity, (Vector{0, 0, 2 * std::acos(-1.0)}));
}

}  // namespace
}  // namespace pliant::test
