#include "engine/accuracy/ladders.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <pliant/error.hpp>

#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::accuracy {
namespace {

const std::string disc = R"(time_limit = 5
[[problem]]
name = "disc"
case = "disc.toml"
set = ["time.end=1"]
rungs = ["discretisation.spacing=0.2", ["discretisation.spacing=0.1", "time.step=0.01"]]
quick = 1
target = [{ measurement = "radius", reference = -2 }]
)";

const std::string two_series = R"(series = [
  { name = "compact" },
  { name = "sph", set = ["method=sph"], rungs = ["discretisation.spacing=0.3"], quick = 0 },
]
)";

struct LadderFile : testing::Test {
  test::TemporaryFolder folder;

  Ladders read(const std::string& text) const {
    std::ofstream(folder / "ladders.toml") << text;
    return read_ladders(folder / "ladders.toml");
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

TEST_F(LadderFile, gives_each_series_the_rungs_of_its_problem_or_its_own) {
  const Ladders ladders = read(disc + two_series);
  EXPECT_EQ(ladders.time_limit, 5);
  const Problem& problem = ladders.problems.at(0);
  EXPECT_EQ(problem.case_file, folder / "disc.toml");
  EXPECT_EQ(problem.targets.at(0).scale, 2);
  ASSERT_EQ(problem.series.size(), 2u);
  EXPECT_EQ(problem.series[0].rungs,
            (std::vector<Rung>{{"discretisation.spacing=0.2"},
                               {"discretisation.spacing=0.1", "time.step=0.01"}}));
  EXPECT_EQ(problem.series[1].rungs, (std::vector<Rung>{{"discretisation.spacing=0.3"}}));
}

TEST_F(LadderFile, is_shortened_by_name_and_for_a_quick_look) {
  const Ladders ladders = read(disc + two_series);
  const Ladders quick = selected(ladders, "", true);
  ASSERT_EQ(quick.problems.at(0).series.size(), 1u);
  EXPECT_EQ(quick.problems[0].series[0].rungs.size(), 1u);
  EXPECT_EQ(selected(ladders, "disc/sph", false).problems.at(0).series.at(0).name, "sph");
  EXPECT_THROW(selected(ladders, "cube", false), InputError);
}

TEST_F(LadderFile, that_is_wrong_is_refused_with_line_and_remedy) {
  expect_refused("[[problem]]\n", "ladders.toml:1: there is no `name`; write name");
  expect_refused(disc, "there is no list of tables `series`; write [[series]]");
  expect_refused(disc + "series = [{ name = \"a\", kernel = \"b\" }]",
                 "ladders.toml:9: there is no key `kernel`");
  expect_refused(disc + "series = [{ name = \"a\", rungs = [1] }]",
                 "ladders.toml:9: a rung is neither a text nor a list of texts; write rungs");
  std::string zero = disc;
  zero.replace(zero.find("-2"), 2, "0");
  expect_refused(zero + two_series, "the scale of a target is not positive; give `scale`");
}

TEST(ladders, that_are_shipped_can_be_read) {
  const Ladders ladders = read_ladders(PLIANT_SOURCE_DIR "/bench/accuracy.toml");
  EXPECT_GE(ladders.problems.size(), 8u);
  for (const Problem& problem : ladders.problems) {
    EXPECT_TRUE(std::filesystem::exists(problem.case_file)) << problem.case_file;
    // A study of convergence needs more than two sizes.
    for (const Series& series : problem.series) EXPECT_GE(series.rungs.size(), 3u) << series.name;
  }
}

}  // namespace
}  // namespace pliant::accuracy
