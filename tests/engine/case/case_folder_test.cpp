#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "engine/simulation/methods.hpp"

namespace pliant {
namespace {

Case read(const std::string& name) {
  return read_case(std::filesystem::path(PLIANT_SOURCE_DIR) / "cases" / name);
}

std::set<std::string> measured(const Case& a_case) {
  std::set<std::string> names;
  for (const MeasurementCase& measurement : a_case.measurements) names.insert(measurement.name);
  return names;
}

TEST(cases, every_folder_holds_a_valid_case_with_its_reference) {
  int count = 0;
  for (const auto& folder :
       std::filesystem::directory_iterator(std::filesystem::path(PLIANT_SOURCE_DIR) / "cases")) {
    const Case a_case = read_case(folder.path() / "case.toml");
    EXPECT_EQ(a_case.name, folder.path().filename().string());
    EXPECT_FALSE(a_case.measurements.empty()) << a_case.name;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "README.md")) << a_case.name;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "reference.csv")) << a_case.name;
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(cases, compression_measures_the_bulge) {
  for (const char* name : {"compression_linear", "compression_hyperelastic"}) {
    const Case a_case = read(name);
    const std::set<std::string> names = measured(a_case);
    EXPECT_TRUE(names.contains("flank_max_displacement"));
    EXPECT_TRUE(names.contains("mid_height_displacement"));
    EXPECT_TRUE(names.contains("surface_max_displacement"));
    EXPECT_EQ(a_case.discretisation.spacing, 1.0 / 32);
    EXPECT_FALSE(a_case.time.step);
    EXPECT_EQ(a_case.bodies.at(0).velocity.translation[1](0, -1, 0, 0), 25);
  }
}

TEST(cases, the_cylinder_measures_what_it_should_keep) {
  const std::set<std::string> names = measured(read("rotating_cylinder"));
  EXPECT_TRUE(names.contains("angular_momentum_ratio"));
  EXPECT_TRUE(names.contains("energy_ratio"));
  EXPECT_TRUE(names.contains("boundary_radius"));
}

TEST(cases, the_plate_measures_its_swing) {
  const std::set<std::string> names = measured(read("oscillating_plate"));
  EXPECT_TRUE(names.contains("flexural_period"));
  EXPECT_TRUE(names.contains("amplitude_ratio_per_period"));
}

// The shape of the mode over its tip value is g(1) = 1, so the tip starts at 0.005 c0 with c0 =
// sqrt(100/1.2) = 9.1287; the constants of the formula have eight digits.
TEST(cases, the_plate_starts_in_its_first_mode) {
  const Case plate = read("oscillating_plate");
  const auto& velocity = plate.bodies.at(0).velocity.translation;
  EXPECT_NEAR(velocity[1](1, 0, 0, 0), 0.045643546, 1e-7);
  EXPECT_NEAR(velocity[1](0, 0, 0, 0), 0, 1e-12);
  const double slope = (velocity[1](1e-4, 0, 0, 0) - velocity[1](0, 0, 0, 0)) / 1e-4;
  EXPECT_NEAR(slope, 0, 1e-4);
}

// The exact waves satisfy the equations of linear elastodynamics, rho d2u/dt2 = mu laplace u +
// (lambda + mu) grad div u. The check uses second differences of step 1e-3, with relative errors of
// about (2 pi 1e-3)^2 from higher derivatives.
TEST(cases, the_exact_waves_solve_the_wave_equation) {
  const Case square = read("periodic_square");
  const kernels::Material<double>& material = square.bodies.at(0).material;
  const double mu = material.shear_modulus, lambda_mu = material.bulk_modulus + mu / 3;
  const MeasurementCase& error = square.measurements.at(0);
  ASSERT_EQ(error.name, "velocity_error_linf");
  const auto u = [&](int i, double x, double y, double t) { return error.exact[i](x, y, 0, t); };
  const double d = 1e-3, x = 0.13, y = 0.29, t = 0.017;
  for (int i = 0; i < 2; ++i) {
    const auto v = [&](double a, double b, double c) { return u(i, x + a, y + b, t + c); };
    const double now = v(0, 0, 0);
    const double u_tt = (v(0, 0, d) - 2 * now + v(0, 0, -d)) / (d * d);
    const double u_xx = (v(d, 0, 0) - 2 * now + v(-d, 0, 0)) / (d * d);
    const double u_yy = (v(0, d, 0) - 2 * now + v(0, -d, 0)) / (d * d);
    const auto w = [&](double a, double b) { return u(1 - i, x + a, y + b, t); };
    const double w_xy = (w(d, d) - w(d, -d) - w(-d, d) + w(-d, -d)) / (4 * d * d);
    const double own = i == 0 ? u_xx : u_yy;
    const double right = mu * (u_xx + u_yy) + lambda_mu * (own + w_xy);
    EXPECT_NEAR(u_tt, right, 2e-3 * std::abs(right));
  }
}

// At t = 0 the exact velocity is the initial one; the formulas agree to rounding.
TEST(cases, the_exact_waves_start_from_the_initial_velocity) {
  const Case square = read("periodic_square");
  const auto& initial = square.bodies.at(0).velocity.translation;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(square.measurements.at(0).exact[i](0.13, 0.29, 0, 0), initial[i](0.13, 0.29, 0, 0),
                1e-18);
  }
}

}  // namespace
}  // namespace pliant
