#include "engine/batch/sweep.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <pliant/error.hpp>

#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

using namespace batch;

struct SweepFile : testing::Test {
  TemporaryFolder folder;

  Sweep read(const std::string& text) const {
    std::ofstream(folder / "sweep.toml") << "case = \"disc.toml\"\n" << text;
    return read_sweep(folder / "sweep.toml");
  }
  void expect_refused(const std::string& text, const std::string& message) const {
    try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
};

TEST_F(SweepFile, is_read_with_its_case_beside_it) {
  const Sweep sweep = read(R"(set = ["time.end=1"]
time_limit = 60
retries = 2
[[design]]
parameters."discretisation.spacing" = [0.1, 0.05]
parameters."body.disc.material.density" = { from = 1, to = 2, count = 3 }
)");
  EXPECT_EQ(sweep.name, "sweep");
  EXPECT_EQ(sweep.case_file, folder / "disc.toml");
  EXPECT_EQ(sweep.settings, std::vector<std::string>{"time.end=1"});
  EXPECT_EQ(sweep.time_limit, 60);
  EXPECT_EQ(sweep.retries, 2);
  EXPECT_EQ(sweep.runs.size(), 6u);
}

TEST_F(SweepFile, keeps_equal_runs_of_several_designs_once) {
  const Sweep sweep = read(R"(
[[design]]
parameters.a = [1, 2]
[[design]]
kind = "zip"
parameters.a = [2.0, 3]
)");
  EXPECT_EQ(sweep.runs, (std::vector<Assignment>{{{"a", "1"}}, {{"a", "2"}}, {{"a", "3"}}}));
}

TEST_F(SweepFile, says_what_a_cluster_needs_to_know) {
  const Sweep sweep = read(R"(
[slurm]
options = ["--partition=short", "--account=a b"]
runs_per_task = 20
[[design]]
parameters.a = [1]
)");
  EXPECT_EQ(sweep.slurm.options, (std::vector<std::string>{"--partition=short", "--account=a b"}));
  EXPECT_EQ(sweep.slurm.runs_per_task, 20);
}

TEST_F(SweepFile, takes_values_of_all_types) {
  const Sweep sweep = read(R"(
[[design]]
parameters.a = ["cfl", true, [0, -10], 5e-5, "2*t"]
)");
  std::vector<std::string> values;
  for (const Assignment& run : sweep.runs) values.push_back(run[0].second);
  EXPECT_EQ(values, (std::vector<std::string>{"'cfl'", "true", "[ 0, -10 ]", "5e-05", "'2*t'"}));
}

TEST_F(SweepFile, takes_the_rows_of_a_table) {
  std::ofstream(folder / "runs.csv") << "a,b\n1,x\n2.50,\"[0, 1]\"\n";
  EXPECT_EQ(read("[[design]]\nkind = \"table\"\nfile = \"runs.csv\"\n").runs,
            (std::vector<Assignment>{{{"a", "1"}, {"b", "x"}}, {{"a", "2.5"}, {"b", "[0, 1]"}}}));
}

TEST_F(SweepFile, samples_intervals) {
  for (const char* kind : {"latin_hypercube", "sobol"}) {
    const Sweep sweep = read("[[design]]\nkind = \"" + std::string(kind) +
                             "\"\nsamples = 7\nseed = 3\nparameters.a = { from = 1, to = 2 }\n");
    ASSERT_EQ(sweep.runs.size(), 7u);
    for (const Assignment& run : sweep.runs) {
      EXPECT_GE(std::stod(run[0].second), 1);
      EXPECT_LT(std::stod(run[0].second), 2);
    }
  }
}

TEST_F(SweepFile, that_is_wrong_is_refused_with_its_line_and_a_remedy) {
  expect_refused("desing = 1\n", "sweep.toml:2: there is no key `desing`; did you mean `design`?");
  expect_refused("", "there is no design; write [[design]]");
  expect_refused("[[design]]\n", "sweep.toml:2: a design has no parameters");
  expect_refused("[[design]]\nkind = \"products\"\nparameters.a = [1]\n",
                 "sweep.toml:3: there is no kind of design \"products\"; did you mean `product`?");
  expect_refused("[[design]]\nkind = \"zip\"\nparameters.a = [1]\nparameters.b = [1, 2]\n",
                 "`a` has 1 values and `b` has 2; give as many");
  expect_refused("[[design]]\nparameters.a = { from = 1 }\n", "sweep.toml:3: `a` has no ends");
  expect_refused("[[design]]\nparameters.a = { from = 0, to = 1, scale = \"log\", count = 2 }\n",
                 "an end that is not positive");
  expect_refused("[[design]]\nparameters.a = { from = 0, to = 1 }\n", "`count` is missing");
  expect_refused("[[design]]\nkind = \"sobol\"\nsamples = 3\nparameters.a = [1]\n",
                 "`a` is a list; write { from = 1, to = 2 }");
  expect_refused("[[design]]\nkind = \"table\"\nfile = \"none.csv\"\n",
                 "\"none.csv\" cannot be read");
  expect_refused("set = [1]\n", "an entry of `set` is no text");
  expect_refused("a = \n", "sweep.toml:2: ");
}

}  // namespace
}  // namespace pliant::test
