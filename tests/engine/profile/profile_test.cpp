#include "engine/profile/profile.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <pliant/error.hpp>
#include <sstream>

#include "engine/case/checks/check.hpp"
#include "engine/case/reading/read_case.hpp"
#include "engine/profile/report.hpp"
#include "engine/profile/trace.hpp"
#include "tests/engine/method/free_flight.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

using namespace profile;

const MethodRegistry& registry() {
  static const MethodRegistry methods({{
      {"free_flight", "particles keep their initial velocity", [](const Check&) {}},
      [](const Case& settings, const SolverOptions& options) -> std::unique_ptr<Solver> {
        return std::make_unique<FreeFlight>(settings, options);
      },
  }});
  return methods;
}

// 16 steps in one second.
Case flight() {
  return parse_case(R"(method = "free_flight"
discretisation = { spacing = 0.25 }
time = { end = 1, step = 0.0625 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
)",
                    "flight.toml", {}, registry().rules());
}

ProfileOptions quarters() {
  ProfileOptions options;
  options.frame_seconds = 0.25;
  options.budget = 10;
  options.warm_up = 1;
  return options;
}

TEST(profile, takes_the_frames_that_the_case_has_after_the_warm_up) {
  const Profile result = run_profile(flight(), quarters(), registry());
  ASSERT_EQ(result.frames.size(), 3u);
  EXPECT_EQ(result.warm_up, 1);
  EXPECT_EQ(result.particles, 16);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(result.frames[i].simulated_time, 0.5 + 0.25 * static_cast<double>(i));
    EXPECT_EQ(result.frames[i].steps, 4);
  }
  ASSERT_EQ(result.steps.size(), 12u);
  EXPECT_DOUBLE_EQ(result.steps[0].simulated_time, 0.3125);
}

TEST(profile, runs_beyond_the_end_of_the_case_when_it_is_asked_for_more_frames) {
  ProfileOptions options = quarters();
  options.frames = 7;
  const Profile result = run_profile(flight(), options, registry());
  ASSERT_EQ(result.frames.size(), 7u);
  EXPECT_DOUBLE_EQ(result.frames.back().simulated_time, 2);
}

TEST(profile, of_a_case_without_a_whole_frame_is_refused) {
  ProfileOptions options;
  options.frame_seconds = 2;
  EXPECT_THROW(run_profile(flight(), options, registry()), InputError);
}

TEST(profile, has_parts_that_add_up_to_each_frame_on_any_number_of_threads) {
  for (const int threads : {1, 2, 3}) {
    ProfileOptions options = quarters();
    options.machine.threads = threads;
    const Profile result = run_profile(flight(), options, registry());
    ASSERT_EQ(result.phases, std::vector<std::string>{"fly"});
    for (const FrameRecord& frame : result.frames) {
      const std::vector<double> parts = parts_of(frame);
      EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0), frame.wall_seconds, 1e-9);
      EXPECT_GT(frame.phase_seconds[0], 0);
      EXPECT_GE(frame.scheduling_seconds, 0);
      EXPECT_GE(frame.waiting_seconds, 0);
    }
  }
}

TEST(profile, ends_as_soon_as_the_budget_cannot_be_held) {
  ProfileOptions options = quarters();
  options.frames = 1000;
  options.budget = 1e-12;
  options.stop_when_missed = true;
  EXPECT_EQ(run_profile(flight(), options, registry()).frames.size(),
            11u);  // 1 % may miss the deadline
}

TEST(trace, holds_every_frame_step_and_node_inside_one_another) {
  const TemporaryFolder folder;
  ProfileOptions options = quarters();
  options.trace = folder / "trace.json";
  run_profile(flight(), options, registry());
  const auto trace = nlohmann::json::parse(std::ifstream(folder / "trace.json"));
  std::map<std::string, int> count;
  for (const auto& event : trace) {
    if (event["ph"] == "X") ++count[event["name"]];
  }
  EXPECT_EQ(count, (std::map<std::string, int>{{"frame", 4}, {"step", 16}, {"fly", 16}}));
  double end_of_step = 0;
  for (const auto& event : trace) {
    if (event["ph"] != "X") continue;
    const double start = event["ts"], stop = start + event["dur"].get<double>();
    constexpr double rounding = 0.03;  // of times with two digits [us]
    if (event["name"] == "step") end_of_step = stop;
    if (event["name"] == "fly") {
      EXPECT_LE(stop, end_of_step + rounding);
    }
  }
}

TEST(trace, keeps_the_longest_nodes_of_a_step_that_has_too_many) {
  const TemporaryFolder folder;
  const int blocks = static_cast<int>(TraceWriter::most_nodes) + 5;
  scheduler::StepGraph graph({{.name = "work", .writes = {{0}}, .run = [](int) {}}},
                             {std::vector<std::vector<int>>(static_cast<std::size_t>(blocks))},
                             {"field"});
  scheduler::Workers workers(1);
  graph.run(workers);
  for (int n = 0; n < blocks; ++n) {
    graph.record().spans[static_cast<std::size_t>(n)] = {0, 1e-6 * (n + 1), 0};
  }
  TraceWriter writer(folder / "trace.json", 1);
  writer.add(graph);
  writer.end_step(TraceWriter::Clock::now(), 1, 1);
  writer.end_frame(TraceWriter::Clock::now(), 1, 1);
  writer.publish();
  const auto trace = nlohmann::json::parse(std::ifstream(folder / "trace.json"));
  std::size_t nodes = 0;
  for (const auto& event : trace) {
    if (event["name"] == "step") {
      EXPECT_EQ(event["args"]["shorter_nodes_left_out"], 5);
    }
    if (event["name"] != "work") continue;
    ++nodes;
    EXPECT_GE(event["dur"], 6);
  }
  EXPECT_EQ(nodes, TraceWriter::most_nodes);
  // 1000 such steps take less than 100 MB.
  EXPECT_LT(std::filesystem::file_size(folder / "trace.json"), 100'000u);
}

TEST(report, holds_all_figures_as_json_and_as_text_of_a_hundred_columns) {
  const Profile result = run_profile(flight(), quarters(), registry());
  const Verdict verdict = judge(result);
  const auto report = nlohmann::json::parse(json_of(result, verdict));
  EXPECT_EQ(report["held"], true);
  EXPECT_EQ(report["frames"]["seconds"].size(), 3u);
  EXPECT_EQ(report["steps"]["seconds"].size(), 12u);
  EXPECT_EQ(report["worst"].size(), 3u);
  EXPECT_EQ(report["worst"][0]["seconds"], verdict.frames.most);
  std::istringstream text(text_of(result, verdict));
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("processor:")) {
      EXPECT_LE(line.size(), 100u) << line;
    }
  }
}

}  // namespace
}  // namespace pliant::test
