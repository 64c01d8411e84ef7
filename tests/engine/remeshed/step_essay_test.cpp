#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "engine/sph/solver.hpp"
#include "tests/invariants/sample_runs.hpp"

// The essays at the top of files with phases name those phases, in their order.
namespace pliant::test {
namespace {

using Names = std::vector<std::string>;

/// The names in the comments of a source file: text between `//` with five spaces and the next two
/// spaces.
Names essay_of(const std::string& source) {
  std::ifstream file(PLIANT_SOURCE_DIR "/engine/" + source);
  const std::string indent = "//     ";
  Names names;
  for (std::string line; std::getline(file, line) && !line.starts_with("namespace");) {
    if (!line.starts_with(indent) || line[indent.size()] == ' ') continue;
    names.push_back(line.substr(indent.size(), line.find("  ", indent.size()) - indent.size()));
  }
  return names;
}

Names names_of(const std::vector<scheduler::Phase>& phases) {
  Names names;
  for (const scheduler::Phase& phase : phases) {
    const bool is_exchange = phase.kind == scheduler::Phase::Kind::exchange;
    const bool is_known = std::ranges::find(names, phase.name) != names.end();
    if (!is_exchange && !is_known) names.push_back(phase.name);
  }
  return names;
}

/// Checks the order of the names in an essay, and removes them from `missing`, the names without a
/// phase so far.
void compare(const Names& found, const Names& essay, Names& missing) {
  auto place = essay.begin();
  for (const std::string& name : found) {
    place = std::find(place, essay.end(), name);
    ASSERT_NE(place, essay.end()) << "the essay does not name `" << name << "` in this place";
    std::erase(missing, name);
  }
}

TEST(essay, of_a_step_names_its_phases_in_their_order) {
  const Names essay = essay_of("remeshed/step.cpp");
  Names missing = essay;
  for (const SampleRun& run : sample_runs()) {
    const Solver solver(run.settled(), {1, kernels::widest_supported()});
    compare(names_of(solver.step_graph().phases()), essay, missing);
  }
  EXPECT_EQ(missing, Names{}) << "no phase has these names";
}

TEST(essay, of_a_step_of_plain_sph_names_its_phases_in_their_order) {
  const Names essay = essay_of("sph/step.cpp");
  Names missing = essay;
  const sph::Solver<double, 2> solver(
      small_case("tensile_instability", {"discretisation.spacing=0.1", "time.step=1e-3"}),
      {1, kernels::widest_supported()});
  compare(names_of(solver.step_graph().phases()), essay, missing);
  EXPECT_EQ(missing, Names{}) << "no phase has these names";
}

TEST(essay, of_a_remeshing_names_its_phases_in_their_order) {
  const Names essay = essay_of("remeshed/remeshing/remesh.cpp");
  Names missing = essay;
  for (const SampleRun& run : sample_runs()) {
    Solver solver(run.settled(), {1, kernels::widest_supported()});
    std::vector<scheduler::Phase> phases;
    solver.remeshing(0).source_phases(phases, 0);
    solver.remeshing(0).target_phases(phases, 0, true);
    compare(names_of(phases), essay, missing);
  }
  EXPECT_EQ(missing, Names{}) << "no phase has these names";
}

}  // namespace
}  // namespace pliant::test
