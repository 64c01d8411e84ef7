#include <gtest/gtest.h>

#include <filesystem>
#include <pliant/pliant.hpp>
#include <string>

#include "tests/engine/api/one_thread.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant {
namespace {

/// A block on the ground, pressed from above; every key is set in code.
CaseFile pressed_block(const std::string& method, const std::string& pressure) {
  CaseFile block;
  block.set("method", method).set("discretisation.spacing", 0.1).set("time.end", 1);
  block.set("material.rubber", R"({ model = "reduced_polynomial", density = 1000,
                                    coefficients = [5000], compressibility = 2e-5 })");
  block.add("body", "block").set("body.block.material", "rubber");
  block.set("body.block.geometry", R"({ shape = "box", lower = [0, 0], upper = [1, 0.8] })");
  block.add("boundary", "ground").set("boundary.ground.kind", "fixed");
  block.set("boundary.ground.geometry",
            R"({ shape = "half_space", point = [0, 0], normal = [0, 1] })");
  block.add("boundary", "top").set("boundary.top.kind", "pressure");
  block.set("boundary.top.pressure", pressure);
  block.set("boundary.top.geometry",
            R"({ shape = "half_space", point = [0, 0.6], normal = [0, -1] })");
  block.add("measurement", "foot").set("measurement.foot.kind", "point_displacement");
  block.set("measurement.foot.point", {0.5, 0.05}).set("measurement.foot.axis", "x");
  return block;
}

std::vector<std::array<double, 3>> positions_after(Simulation& simulation, double time) {
  simulation.advance(time);
  return simulation.positions(0);
}

class EveryMethod : public testing::TestWithParam<std::string> {};

TEST_P(EveryMethod, a_pressure_set_between_steps_acts_as_that_of_the_case) {
  Simulation prescribed(pressed_block(GetParam(), "300"), one_thread());
  Simulation set(pressed_block(GetParam(), "0"), one_thread());
  set.set_pressure("top", 300);
  EXPECT_EQ(positions_after(prescribed, 0.05), positions_after(set, 0.05));
}

TEST_P(EveryMethod, a_wall_that_is_set_in_motion_takes_the_block_along) {
  Simulation simulation(pressed_block(GetParam(), "0"), one_thread());
  simulation.set_wall_velocity("ground", {0.5, 0, 0});
  simulation.advance(0.1);
  EXPECT_NEAR(0.05, simulation.measurement("foot"), 0.01);
}

TEST_P(EveryMethod, a_restored_simulation_continues_to_the_same_bits_with_the_loads_that_were_set) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "state.h5";
  Simulation whole(pressed_block(GetParam(), "0"), one_thread());
  whole.set_pressure("top", 300);
  whole.advance(0.02);
  whole.save(file);
  Simulation restored(pressed_block(GetParam(), "0"), one_thread());
  restored.restore(file);
  EXPECT_EQ(0.02, restored.time());
  EXPECT_EQ(positions_after(whole, 0.05), positions_after(restored, 0.05));
}

TEST_P(EveryMethod, fields_are_the_arrays_of_the_solver_and_their_runs_hold_every_particle) {
  Simulation simulation(pressed_block(GetParam(), "300"), one_thread());
  simulation.advance(0.02);
  const FieldView velocity = simulation.field(0, "velocity"), mass = simulation.field(0, "mass");
  ASSERT_EQ(2u, velocity.values.size());
  EXPECT_EQ("m/s", velocity.unit);
  EXPECT_EQ(velocity.values[0].data(), simulation.field(0, "velocity").values[0].data());
  std::int64_t count = 0;
  double momentum = 0;
  for (const SlotRun& run : simulation.particles(0)) {
    for (std::int64_t p = run.first; p < run.last; ++p, ++count) {
      momentum += mass.values[0][p] * velocity.values[1][p];
    }
  }
  EXPECT_EQ(simulation.particle_count(), count);
  EXPECT_LT(momentum, 0);
}

TEST_P(EveryMethod, a_state_of_another_case_is_refused) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "state.h5";
  Simulation(pressed_block(GetParam(), "1"), one_thread()).save(file);
  Simulation other(pressed_block(GetParam(), "2"), one_thread());
  EXPECT_THROW(other.restore(file), InputError);
}

INSTANTIATE_TEST_SUITE_P(Simulation, EveryMethod, testing::Values("remeshed", "total_lagrangian"),
                         [](const auto& method) { return method.param; });

TEST(Simulation, names_that_do_not_exist_are_refused_with_those_that_do) {
  Simulation simulation(pressed_block("total_lagrangian", "0"), one_thread());
  EXPECT_THROW(simulation.set_pressure("ground", 1), InputError);
  EXPECT_THROW(simulation.set_pressure("sky", 1), InputError);
  EXPECT_THROW(simulation.positions(1), InputError);
  try {
    simulation.field(0, "velocitty");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("`velocity`")) << error.what();
  }
}

TEST(Simulation, what_is_wrong_with_a_case_is_told_with_the_key) {
  try {
    Simulation simulation(pressed_block("remeshed", "0").set("time.endd", 1));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("time.endd")) << error.what();
  }
}

}  // namespace
}  // namespace pliant
