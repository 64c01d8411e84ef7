#include "engine/method/registry.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "engine/case/checks/stability.hpp"
#include "engine/case/writing/reference.hpp"
#include "engine/case/writing/resolved.hpp"
#include "engine/case/writing/validate_summary.hpp"
#include "engine/output/error.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/run.hpp"
#include "tests/engine/method/free_flight.hpp"
#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

// What the guide for contributors lists: a solver, rules for case files, and an entry in a
// registry.

const MethodRegistry& test_methods() {
  static const MethodRegistry registry({{
      {.word = "free_flight",
       .meaning = "particles keep their initial velocity",
       .check = check_flight,
       .keys = visit_keys,
       .step_limits = limits_of_flight,
       .summary = [](const Case& a_case) { return fmt::format("drag {}/s", drag_of(a_case)); }},
      [](const Case& settings, const SolverOptions& options) -> std::unique_ptr<Solver> {
        return std::make_unique<FreeFlight>(settings, options);
      },
  }});
  return registry;
}

const std::string flight = R"(method = "free_flight"
discretisation = { spacing = 0.25 }
time = { end = 1, step = 0.0625 }
output = { every = 0.25, checkpoint_every = 0.5 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
velocity = [3, 0]
[[measurement]]
name = "momentum"
kind = "momentum"
axis = "x"
)";

struct OtherMethod : testing::Test {
  TemporaryFolder folder;

  Case read(const std::string& text = flight, const std::vector<std::string>& set = {}) const {
    std::ofstream(folder / "flight.toml") << text;
    return read_case(folder / "flight.toml", set, test_methods().rules());
  }
  std::string refusal(const std::vector<std::string>& set) const {
    try {
      read(flight, set);
      return "";
    } catch (const CaseError& error) {
      return error.what();
    }
  }
  RunEnd run(bool resume = false) const {
    RunOptions options;
    options.folder = folder / "out";
    options.quiet = true;
    options.resume = resume;
    return run_case(read(), options, test_methods());
  }
  FileContent result() const { return content_of(folder / "out" / "result.h5"); }
};

TEST_F(OtherMethod, runs_from_a_case_file_to_its_results) {
  ASSERT_EQ(run(), RunEnd::done);
  const FileContent content = result();
  const auto times = content.at("/VTKHDF/Steps/Values").as<double>();
  const auto positions = content.at("/VTKHDF/Points").as<double>();
  ASSERT_EQ(times, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  ASSERT_EQ(positions.size(), 5u * 16 * 3);
  const double* last = positions.data() + 4 * 16 * 3;
  for (int i = 0; i < 16 * 3; ++i) EXPECT_EQ(last[i], positions[i] + (i % 3 == 0 ? 3 : 0)) << i;
  EXPECT_EQ(content.at("/measurements/momentum/value").as<double>().back(), 6);
  std::ifstream summary(folder / "out" / "summary.json");
  const std::string text{std::istreambuf_iterator<char>(summary), {}};
  EXPECT_NE(text.find(R"("method": "free_flight")"), text.npos) << text;
}

TEST_F(OtherMethod, resumes_from_its_checkpoint_to_the_same_results) {
  ASSERT_EQ(run(), RunEnd::done);
  const FileContent whole = result();
  ASSERT_EQ(run(true), RunEnd::done);
  EXPECT_EQ(differences(whole, result()), std::vector<std::string>());
}

TEST_F(OtherMethod, does_not_continue_from_a_state_of_another_method) {
  ArchiveWriter writer(folder / "state.h5");
  writer.put("method", std::string_view("remeshed"));
  writer.commit();
  const auto solver = test_methods().make(read(), {});
  EXPECT_THROW(solver->restore(ArchiveReader(folder / "state.h5")), OutputError);
}

TEST_F(OtherMethod, refuses_what_it_cannot_do_at_its_line) {
  const std::string contact = flight + "[[contact]]\nbodies = [\"block\", \"block\"]\n";
  try {
    read(contact);
    FAIL() << "a contact was accepted";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("method \"free_flight\" has no [[contact]]"),
              std::string::npos)
        << error.what();
  }
}

// u (1 - c dt)^n after n = 16 steps.
TEST_F(OtherMethod, has_keys_of_its_own) {
  const auto solver = test_methods().make(read(flight, {"free_flight.drag=2"}), {});
  solver->advance(1);
  EXPECT_NEAR(solver->measure(0), 6 * std::pow(1 - 2 * 0.0625, 16), 1e-12);
  EXPECT_NE(resolved_toml(solver->settings()).find("[free_flight]\ndrag = 2\n"), std::string::npos);
  EXPECT_NE(case_reference_markdown(test_methods().rules())
                .find("| `drag` | number, 0 or more | 1/s | `0` | rate at which"),
            std::string::npos);
  EXPECT_NE(refusal({"free_flight.drag=-1"}).find("drag must be 0 or more, got -1"),
            std::string::npos);
  EXPECT_NE(refusal({"free_flight.drug=1"}).find("did you mean `drag`?"), std::string::npos);
}

TEST_F(OtherMethod, has_a_check_a_stability_limit_and_a_summary_of_its_own) {
  EXPECT_NE(refusal({"time.step=\"cfl\""}).find("free flight has no CFL number"),
            std::string::npos);
  EXPECT_EQ(stability_warning(read(flight, {"free_flight.drag=30"})), "");
  EXPECT_NE(stability_warning(read(flight, {"free_flight.drag=40"}))
                .find("the time step 0.0625 s is above the stability limit of 0.05 s"),
            std::string::npos);
  EXPECT_NE(validate_summary(read(flight, {"free_flight.drag=2"})).find("drag 2/s"),
            std::string::npos);
}

TEST_F(OtherMethod, does_not_take_the_keys_of_others) {
  EXPECT_NE(refusal({"sph.artificial_stress=1"}), "");
  EXPECT_NE(refusal({"remeshing.every=10"}), "");
  EXPECT_NE(refusal({"discretisation.kernel=compact"}), "");
}

TEST_F(OtherMethod, is_unknown_to_the_program_and_does_not_run_as_another) {
  EXPECT_THROW(read_case(folder / "flight.toml"), CaseError);
  Case settings = read();
  EXPECT_THROW(methods().make(settings, {}), std::invalid_argument);
  settings.method = "remeshed";
  EXPECT_THROW(test_methods().make(settings, {}), std::invalid_argument);
}

TEST(shipped_methods, are_found_by_their_words) {
  for (const char* word : {"remeshed", "sph", "total_lagrangian"}) {
    EXPECT_EQ(methods().find(word).rules.word, word);
  }
}

}  // namespace
}  // namespace pliant::test
