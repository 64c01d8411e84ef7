#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/simulation/histories.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Published benchmarks: the beam of Turek & Hron (2006) of cases/swinging_beam, lengths in mm.
namespace pliant::test {
namespace {

std::unique_ptr<Solver> beam(std::vector<std::string> settings) {
  return methods().make(read_case(PLIANT_SOURCE_DIR "/cases/swinging_beam", settings), {2});
}

TEST(swinging_beam, rests_where_other_programs_have_it) {
  struct Rest {
    std::string method, youngs_modulus, spacing;
    double x, y, bar;
  };
  const std::string soft = "1.4e6", stiff = "5.6e6";
  for (const Rest& rest : {Rest{"total_lagrangian", soft, "0.005", -7.187, -66.10, 0.0035},
                           Rest{"total_lagrangian", soft, "0.0025", -7.187, -66.10, 0.0015},
                           Rest{"total_lagrangian", stiff, "0.005", -0.4690, -16.97, 0.0035},
                           Rest{"point_based", soft, "0.0025", -7.187, -66.10, 0.01},
                           Rest{"point_based", stiff, "0.005", -0.4690, -16.97, 0.03}}) {
    const auto run = beam({"method=" + rest.method, rest.method + ".damping=4",
                           "discretisation.spacing=" + rest.spacing,
                           "body.beam.material.youngs_modulus=" + rest.youngs_modulus});
    run->advance(5);
    auto tip = values(*run);
    EXPECT_NEAR(1e3 * tip["tip_x"] / rest.x, 1, rest.bar) << rest.method;
    EXPECT_NEAR(1e3 * tip["tip_y"] / rest.y, 1, rest.bar) << rest.method;
  }
}

// The published deepest points for three time steps are 129.07, 129.71 and 128.77 mm below.
TEST(swinging_beam, swings_as_deep_and_as_fast_as_other_programs_have_it) {
  const auto run = beam({});
  Histories histories(run->settings());
  for (int sample = 0; sample <= 1000; ++sample) {
    run->advance(0.01 * sample);
    histories.add(run->clock().time, run->measure());
  }
  EXPECT_NEAR(1e3 * histories.last(2), -28.61, 0.03 * 28.61);
  EXPECT_NEAR(1e3 * histories.last(3), -128.77, 0.01 * 128.77);
  EXPECT_NEAR(histories.last(4), 0.9095, 0.005 * 0.9095);
  EXPECT_NEAR(balance(*run), 0, 1e-5 * run->energy_budget()->body_force_work);
}

}  // namespace
}  // namespace pliant::test
