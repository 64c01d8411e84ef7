#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Cases, compared with the independent computations in their folders.
namespace pliant::test {
namespace {

/// A column of the reference.csv of a case over its first column, time.
struct Reference {
  std::vector<double> time, value;

  Reference(const std::string& case_name, const std::string& column) {
    std::ifstream file(PLIANT_SOURCE_DIR "/cases/" + case_name + "/reference.csv");
    std::string line, cell;
    std::getline(file, line);
    std::size_t position = 0, found = 0;
    for (std::istringstream names(line); std::getline(names, cell, ','); ++position) {
      if (cell == column) found = position;
    }
    EXPECT_GT(found, 0u) << "no column " << column;
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      for (std::size_t c = 0; std::getline(cells, cell, ','); ++c) {
        if (c == 0) time.push_back(std::stod(cell));
        if (c == found) value.push_back(std::stod(cell));
      }
    }
  }
};

/// Runs a case to `end`, and expects a measurement to follow the reference within `tolerance` at
/// all times of the reference.
template <int D = 2>
void expect_followed(const Case& settings, const std::string& measurement,
                     const Reference& reference, double end, double tolerance) {
  std::size_t m = 0;
  while (settings.measurements.at(m).name != measurement) ++m;
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  int compared = 0;
  for (std::size_t i = 0; i < reference.time.size() && reference.time[i] <= end; ++i) {
    advance_until(solver, reference.time[i]);
    EXPECT_NEAR(solver.measure()[m], reference.value[i], tolerance) << "t = " << reference.time[i];
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

// The corners at the ends of the pistons are singular and contribute to the tolerances.
TEST(references, compression_of_a_linear_solid_follows_finite_elements) {
  const Reference bulge("compression_linear", "u_x_flank_mid_height");
  expect_followed(small_case("compression_linear", {"discretisation.spacing=1/32"}),
                  "mid_height_displacement", bulge, 0.02, 0.01 * 0.2437);
}

TEST(references, compression_of_a_hyperelastic_solid_follows_finite_elements) {
  const Reference bulge("compression_hyperelastic", "u_x_flank_mid_height");
  expect_followed(small_case("compression_hyperelastic", {"discretisation.spacing=1/32"}),
                  "mid_height_displacement", bulge, 0.02, 0.01 * 0.2507);
}

TEST(references, a_rotating_cylinder_breathes_as_the_exact_solution_does) {
  const Reference radius("rotating_cylinder", "radius");
  expect_followed(small_case("rotating_cylinder", {}), "boundary_radius", radius, 0.5, 0.003);
}

TEST(references, a_plate_swings_out_as_finite_elements_do) {
  const Reference tip("oscillating_plate", "tip_displacement");
  // A quarter of the period of 5.94 s; 2 % of the amplitude of 0.043.
  expect_followed(small_case("oscillating_plate", {}), "tip_displacement", tip, 1.5, 0.02 * 0.043);
}

// The closed form, except for rounding: the medium stays as uniform as it starts.
TEST(references, a_suddenly_compressed_medium_relaxes_by_its_prony_series) {
  const Settings flight = {"dimension=3",
                           "discretisation.spacing=0.2",
                           "discretisation.dissipation=1",  // for five cells to a period
                           "periodic.axes=[\"x\", \"y\", \"z\"]",
                           "periodic.lower=[0, 0, 0]",
                           "periodic.upper=[1, 1, 1]",
                           "body.medium.geometry={ shape = \"box\", lower = [0, 0, 0], upper = [1, "
                           "1, 1] }",
                           "body.medium.velocity=[1, 0.7, 0.3]",
                           "body.medium.stretch=[1, 0.95, 1]",
                           "measurement.pressure.point=[0.5, 0.5, 0.5]"};
  for (const std::string moduli : {"long_term", "instantaneous"}) {
    const Reference pressure("prony_step", "pressure_" + moduli);
    const Settings choice = {"material.rubber.prony.moduli=" + moduli};
    expect_followed(small_case("prony_step", choice), "pressure", pressure, 50, 1e-9);
    expect_followed<3>(small_case("prony_step", choice + flight), "pressure", pressure, 5, 1e-9);
  }
}

// The reference is accurate to 0.25 % of the momentum of 0.393 N s.
TEST(references, colliding_discs_exchange_momentum_as_finite_elements_do) {
  expect_followed(small_case("two_discs", {}), "momentum_of_left",
                  Reference("two_discs", "momentum"), 0.4, 0.01 * 0.393);
}

// Exact integrals over the solid inside the triangles, which free flight conserves. The surface is
// resolved to about (h/40 mm)^2, and every remeshing smooths the fields a little.
TEST(references, a_thrown_organ_keeps_what_its_mesh_and_velocity_give_it) {
  const Case organ = small_case("organ", {"discretisation.spacing=0.008"});
  const std::pair<const char*, double> tolerances[] = {
      {"mass", 0.01 * 1.86}, {"momentum_x", 0.01 * 0.807}, {"angular_momentum_z", 0.02 * 0.031}};
  for (const auto& [name, tolerance] : tolerances) {
    expect_followed<3>(organ, name, Reference("organ", name), 0.08, tolerance);
  }
}

}  // namespace
}  // namespace pliant::test
