#include "engine/method/registry.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/output/error.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/run.hpp"
#include "tests/engine/method/free_flight.hpp"
#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

// What the guide to contributors lists: a solver, rules for case files, and a place in a registry.

void refuse_contacts(const Check& check) { refuse_tables(check, {"contact"}); }

const MethodRegistry& test_methods() {
  static const MethodRegistry registry({{
      {"free_flight", "particles keep their initial velocity", refuse_contacts},
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

  Case read(const std::string& text = flight) const {
    std::ofstream(folder / "flight.toml") << text;
    return read_case(folder / "flight.toml", {}, test_methods().rules());
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
