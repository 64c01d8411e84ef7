#include "engine/batch/designs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace pliant::test {
namespace {

using namespace batch;

TEST(designs, ranges_include_both_ends) {
  EXPECT_EQ(range_of({"a", 0.1, 0.3, false}, 3).values,
            (std::vector<std::string>{"0.1", "0.2", "0.3"}));
  EXPECT_EQ(range_of({"a", 1, 100, true}, 3).values, (std::vector<std::string>{"1", "10", "100"}));
  EXPECT_EQ(range_of({"a", 2, 5, false}, 1).values, std::vector<std::string>{"2"});
}

TEST(designs, products_combine_everything_and_zips_go_in_step) {
  const std::vector<ValueList> lists = {{"a", {"1", "2"}}, {"b", {"x", "y"}}};
  EXPECT_EQ(product_of(lists), (std::vector<Assignment>{{{"a", "1"}, {"b", "x"}},
                                                        {{"a", "1"}, {"b", "y"}},
                                                        {{"a", "2"}, {"b", "x"}},
                                                        {{"a", "2"}, {"b", "y"}}}));
  EXPECT_EQ(zip_of(lists), (std::vector<Assignment>{{{"a", "1"}, {"b", "x"}},  //
                                                    {{"a", "2"}, {"b", "y"}}}));
}

TEST(designs, latin_hypercubes_have_one_sample_in_each_part_of_each_interval) {
  constexpr int samples = 20;
  const auto all = latin_hypercube({{"a", 0, 20, false}, {"b", 1, 1e20, true}}, samples, 4);
  std::set<int> parts_a, parts_b;
  for (const Assignment& run : all) {
    parts_a.insert(static_cast<int>(std::stod(run[0].second)));
    parts_b.insert(static_cast<int>(std::log10(std::stod(run[1].second))));
  }
  EXPECT_EQ(parts_a.size(), static_cast<std::size_t>(samples));
  EXPECT_EQ(parts_b.size(), static_cast<std::size_t>(samples));
  EXPECT_NE(all, latin_hypercube({{"a", 0, 20, false}, {"b", 1, 1e20, true}}, samples, 5));
}

TEST(designs, more_samples_of_a_sobol_sequence_keep_those_that_there_are) {
  const std::vector<Interval> intervals = {{"a", 0, 1, false}, {"b", 2, 3, false}};
  const auto few = sobol(intervals, 5, 1), many = sobol(intervals, 9, 1);
  EXPECT_EQ(few, std::vector<Assignment>(many.begin(), many.begin() + 5));
}

TEST(designs, names_of_runs_depend_on_their_values_alone) {
  EXPECT_EQ(name_of({{"a", "1"}, {"b", "2"}}), name_of({{"b", "2"}, {"a", "1"}}));
  EXPECT_NE(name_of({{"a", "1"}, {"b", "2"}}), name_of({{"a", "2"}, {"b", "1"}}));
  EXPECT_EQ(name_of({{"a", number_text(0.1)}}), name_of({{"a", number_text(0.10)}}));
  EXPECT_EQ(name_of({{"a", "1"}}).size(), 13u);
}

}  // namespace
}  // namespace pliant::test
