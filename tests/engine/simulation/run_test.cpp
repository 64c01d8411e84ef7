#include "engine/simulation/run.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

struct Running : testing::Test {
  TemporaryFolder folder;
  const Settings quick = {"discretisation.spacing=0.1", "time.end=0.021", "output.every=0.005"};

  RunEnd run(const Settings& more, bool resume = false) const {
    RunOptions options;
    options.folder = folder / "out";
    options.quiet = true;
    options.isa = kernels::widest_supported();
    options.resume = resume;
    return run_case(small_case("rotating_cylinder", quick + more), options);
  }

  std::vector<double> result(const std::string& path) const {
    return content_of(folder / "out" / "result.h5").at(path).as<double>();
  }
};

TEST_F(Running, leaves_all_its_files) {
  EXPECT_EQ(run({}), RunEnd::done);
  for (const char* file : {"result.h5", "result.xdmf", "summary.json", "case.resolved.toml"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / file)) << file;
  }
}

TEST_F(Running, says_what_it_took_of_the_machine) {
  run({});
  const auto summary = nlohmann::json::parse(text_of(folder / "out" / "summary.json"));
  EXPECT_GT(summary["processor_time"], 0);
  EXPECT_GT(summary["peak_memory"], 1'000'000);
}

TEST_F(Running, frames_come_at_their_times_and_at_both_ends) {
  run({});
  const std::vector<double> times = result("/VTKHDF/Steps/Values");
  const std::vector<double> expected = {0, 0.005, 0.01, 0.015, 0.02, 0.021};
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-15);
}

// Both runs have frames at the same times with the same bits, some of them between two steps.
TEST_F(Running, output_times_change_no_bit_of_what_is_seen) {
  for (const Settings& policy : {Settings{}, Settings{"remeshing.every=3"}}) {
    run(policy + Settings{"output.measure_every=0.02"});
    const FileContent seldom = content_of(folder / "out" / "result.h5");
    run(policy + Settings{"output.measure_every=0.0007", "output.checkpoint_every=0.0011"});
    for (const char* field : {"velocity", "displacement", "stress", "density"}) {
      const std::string path = std::string("/VTKHDF/PointData/") + field;
      EXPECT_EQ(seldom.at(path).as<double>(), result(path)) << field;
    }
    EXPECT_EQ(seldom.at("/measurements/energy_ratio/value").as<double>().back(),
              result("/measurements/energy_ratio/value").back());
  }
}

// A bar that strains by 2 % has no remeshings, and a case without remeshings none at all.
TEST_F(Running, forces_are_those_of_the_end_without_an_interval_of_samples) {
  const std::string bar = R"toml(dimension = 2
discretisation = { spacing = 0.1 }
time = { end = 2 }
[material.m]
model = "neo_hookean"
youngs_modulus = 100
poissons_ratio = 0
density = 1
[[body]]
name = "bar"
material = "m"
geometry = { shape = "box", lower = [0, 0], upper = [2, 1] }
[[boundary]]
name = "left"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[boundary]]
name = "right"
kind = "moving_wall"
displacement = ["0.01*t^2", 0]
geometry = { shape = "half_space", point = [2, 0], normal = [-1, 0] }
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "left"
)toml";
  for (const char* method : {"remeshed", "total_lagrangian", "point_based"}) {
    RunOptions options;
    options.folder = folder / method;
    options.quiet = true;
    run_case(tests::read_text(bar, {std::string("method=") + method}), options);
    const FileContent results = content_of(folder / method / "result.h5");
    // Waves need 0.2 s for the bar, in which the force grows by 0.1 to 0.2 of its value.
    EXPECT_NEAR(results.at("/measurements/force/value").as<double>().back(), -2, 0.3) << method;
  }
}

TEST_F(Running, a_checkpoint_of_another_case_is_refused) {
  run({});
  EXPECT_THROW(run({"body.cylinder.material.youngs_modulus=99"}, true), InputError);
}

}  // namespace
}  // namespace pliant::test
