#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/solver.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/snapshot.hpp"

// Orders of convergence and conserved quantities of whole runs.
namespace pliant::test {
namespace {

/// Largest error of the velocity over its amplitude, compared with the exact waves, at the end of
/// the case `periodic_square` or `periodic_cube` with `cells` particles to a wavelength.
template <int D = 2>
double wave_error(int cells, const Settings& material) {
  const Case settings =
      small_case(D == 2 ? "periodic_square" : "periodic_cube",
                 Settings{"discretisation.spacing=1/" + std::to_string(cells)} + material);
  EXPECT_EQ(settings.measurements[0].name, "velocity_error_linf");
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, settings.time.end);
  EXPECT_GE(solver.clock().remeshings, 5);
  return solver.measure()[0];
}

double order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

TEST(convergence, plane_waves_in_a_linear_solid_converge_at_second_order) {
  EXPECT_GE(order(wave_error(16, {}), wave_error(64, {}), 4), 1.95);
}

TEST(convergence, plane_waves_in_a_hyperelastic_solid_converge_at_second_order) {
  // mu = 2 C10 = 20 and K = 2/D = 2; omega = 2 pi sqrt(2) c with c_S^2 = 20 and c_P^2 = K + 4 mu/3.
  const std::string wave =
      "0.0005*(cos(2*pi*(x - y))*cos(2*pi*sqrt(2*20)*t) - "
      "cos(2*pi*(x + y))*cos(2*pi*sqrt(2*86/3)*t))";
  const Settings hyperelastic = {
      "body.medium.material={ model = \"reduced_polynomial\", coefficients = [10], "
      "compressibility = 1, density = 1 }",
      "time.end=0.158113883008",
      "measurement.velocity_error_linf.exact=[\"" + wave + "\", \"" + wave + "\"]"};
  EXPECT_GE(order(wave_error(16, hyperelastic), wave_error(64, hyperelastic), 4), 1.95);
}

/// Velocity amplitude after the time `end` of the standing pressure wave q(t) sin(2 pi x) in the
/// material of `damped_wave_error`, from its equations of motion in many small steps of the
/// midpoint rule: rho q'' = -k^2 [(K0 + 4 mu/3) q - sum P_i], P_i + tau_i P_i' = g_i K0 q.
double damped_amplitude(double start, double end, double viscous = 1) {
  constexpr int terms = 2;
  constexpr double ratio[terms] = {0.3, 0.2}, time[terms] = {0.005, 0.05};
  constexpr double k = 2 * std::numbers::pi, modulus = 100, stiffness = modulus + 4. / 3 * 20;
  using State = std::array<double, 2 + terms>;  // q, q', P_i
  const auto rate = [&](const State& s) {
    State r = {s[1], -k * k * (stiffness * s[0] - s[2] - s[3])};
    for (int i = 0; i < terms; ++i)
      r[2 + i] = (viscous * ratio[i] * modulus * s[0] - s[2 + i]) / time[i];
    return r;
  };
  const auto moved = [](State s, const State& r, double dt) {
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += dt * r[i];
    return s;
  };
  State s = {0, start};
  constexpr int steps = 20000;
  const double dt = end / steps;
  for (int n = 0; n < steps; ++n) s = moved(s, rate(moved(s, rate(s), dt / 2)), dt);
  return s[1];
}

constexpr double damped_time = 0.2;

/// Error of the velocity of the wave at its crest over the amplitude at the start.
double damped_wave_error(int cells) {
  const double amplitude = 1e-4, end = damped_time;
  const Case settings = small_case(
      "periodic_square",
      {"discretisation.spacing=1/" + std::to_string(cells), fmt::format("time.end={}", end),
       "body.medium.material={ model = \"reduced_polynomial\", coefficients = [10], density = 1, "
       "compressibility = 0.02, prony = { ratios = [0.3, 0.2], times = [0.005, 0.05], moduli = "
       "\"instantaneous\" } }",
       fmt::format("body.medium.velocity=[\"{}*sin(2*pi*x)\", 0]", amplitude)});
  EXPECT_EQ(settings.measurements[1].name, "crest_velocity");
  Solver solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, end);
  const double crest = solver.measure()[1];
  return std::abs(crest - damped_amplitude(amplitude, end)) / amplitude;
}

TEST(convergence, bulk_viscosity_damps_pressure_waves_to_second_order) {
  // Otherwise the test would prove nothing.
  EXPECT_GT(std::abs(damped_amplitude(1, damped_time) - damped_amplitude(1, damped_time, 0)), 0.3);
  EXPECT_GE(order(damped_wave_error(16), damped_wave_error(64), 4), 1.95);
}

TEST(convergence, waves_in_a_linear_cube_converge_at_second_order) {
  EXPECT_GE(order(wave_error<3>(16, {}), wave_error<3>(32, {}), 2), 1.95);
}

/// State of a periodic cell in strong motion, never remeshed, after `steps` steps to a fixed time.
Snapshot lively_motion(int steps) {
  const double end = 0.04;
  const Case settings = small_case(
      "periodic_square",
      {"discretisation.spacing=1/16", "remeshing.every=never",
       fmt::format("time.step={}", end / steps),
       "body.medium.velocity=[\"0.5*sin(2*pi*x)*cos(2*pi*y)\", \"0.4*sin(2*pi*(x + y))\"]"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance(solver, steps);
  EXPECT_NEAR(solver.clock().time, end, 1e-12);
  EXPECT_EQ(solver.clock().remeshings, 0);
  return snapshot_of(solver, Slots::particles);
}

TEST(convergence, time_steps_converge_at_fourth_order) {
  const Snapshot exact = lively_motion(640), coarse = lively_motion(40), fine = lively_motion(80);
  for (const char* field : {"drift", "velocity", "volume", "material_state"}) {
    const double a = relative_difference(exact, coarse, field);
    const double b = relative_difference(exact, fine, field);
    EXPECT_GE(order(a, b, 2), 3.9) << field;
    EXPECT_GT(b, 1e-11) << field << " shows rounding only";
  }
}

TEST(convergence, a_spinning_disc_keeps_its_angular_momentum_and_energy) {
  Solver solver(small_case("rotating_cylinder", {"remeshing.every=10"}),
                {2, kernels::widest_supported()});
  const BodyIntegrals start = solver.integrals();
  for (int part = 1; part <= 4; ++part) {
    advance_until(solver, 0.025 * part);
    const BodyIntegrals now = solver.integrals();
    EXPECT_NEAR(now.angular_momentum[2] / start.angular_momentum[2], 1, 1e-3);
    // The Jaumann law has no potential: for the exact solution this sum varies by 0.22 %.
    EXPECT_NEAR(
        (now.kinetic_energy + now.strain_energy) / (start.kinetic_energy + start.strain_energy), 1,
        4e-3);
    EXPECT_NEAR(now.mass / start.mass, 1, 1e-3);
  }
}

/// Share of their energy that two discs keep in a collision, with `cells` particles to a radius.
double kept_energy(int cells) {
  Solver solver(small_case("two_discs", {"discretisation.spacing=0.5/" + std::to_string(cells)}),
                {2, kernels::widest_supported()});
  const BodyIntegrals start = solver.integrals();
  advance_until(solver, 0.45);  // they have separated
  const BodyIntegrals end = solver.integrals();
  EXPECT_NEAR(end.momentum[0], start.momentum[0], 1e-12 * 0.39);
  return (end.kinetic_energy + end.strain_energy) / start.kinetic_energy;
}

// What the discs lose falls with the spacing. With 5 particles to the radius the patch of contact
// is two of them wide.
TEST(convergence, colliding_discs_keep_their_energy_to_two_percent) {
  EXPECT_NEAR(kept_energy(5), 1, 0.1);
  EXPECT_NEAR(kept_energy(20), 1, 0.02);
}

// Without friction, with edges on edges; the run was stopped within 0.5 s.
TEST(convergence, equal_cubes_rest_on_each_other) {
  const auto cube = [](const std::string& name, const std::string& low, const std::string& high) {
    return "[[body]]\nname = \"" + name +
           "\"\ngeometry = { shape = \"box\", lower = [-0.0625, -0.0625, " + low +
           "], upper = [0.0625, 0.0625, " + high +
           "] }\nmaterial = { model = \"linear\", youngs_modulus = 100, poissons_ratio = 0.3, "
           "density = 1 }\n";
  };
  const Case settings = tests::read_text(
      "dimension = 3\ngravity = [0, 0, -10]\n"
      "discretisation = { spacing = 0.025, damping = \"adaptive\" }\ntime = { end = 1 }\n" +
      cube("lower", "0", "0.125") + cube("upper", "0.125", "0.25") + R"toml(
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [0, 0, 1] }
[[contact]]
bodies = ["upper", "lower"]
[[measurement]]
name = "push"
kind = "contact_force"
bodies = ["upper", "lower"]
axis = "z"
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "floor"
axis = "z"
)toml");
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, 0.4);
  const std::vector<double> before = solver.measure();
  advance_until(solver, 0.5);
  const std::vector<double> after = solver.measure();
  const double weight = 10 * std::pow(0.125, 3);
  EXPECT_NEAR((after[0] - before[0]) / 0.1, weight, 0.03 * weight);
  EXPECT_NEAR((after[1] - before[1]) / 0.1, 2 * weight, 0.03 * 2 * weight);
}

/// Errors of the transmitted and the reflected amplitude at a tied interface, relative to the
/// incoming one.
std::array<double, 2> interface_errors(int cells) {
  const double h = 1. / cells;
  const Settings settings = {fmt::format("discretisation.spacing={}", h),
                             fmt::format("periodic.upper=[inf, {}]", 8 * h),
                             fmt::format("measurement.reflected.point=[-0.25, {}]", 4 * h),
                             fmt::format("measurement.transmitted.point=[0.125, {}]", 4 * h)};
  const Case bar = small_case("bimaterial_bar", settings);
  EXPECT_EQ(bar.measurements[0].name, "reflected");
  EXPECT_EQ(bar.measurements[1].name, "transmitted");
  Solver solver(bar, {2, kernels::widest_supported()});
  advance_until(solver, bar.time.end);
  const std::vector<double> values = solver.measure();
  return {values[0] / 0.01 + 1. / 3, values[1] / 0.01 - 2. / 3};  // Z2 = 2 Z1
}

TEST(convergence, an_interface_passes_and_returns_what_the_impedances_say) {
  const auto coarse = interface_errors(100), fine = interface_errors(200);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT(std::abs(fine[i]), 0.005);
    EXPECT_GE(order(std::abs(coarse[i]), std::abs(fine[i]), 2), 1.5);
  }
}

}  // namespace
}  // namespace pliant::test
