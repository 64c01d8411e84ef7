#include "engine/profile/duration.hpp"

#include <gtest/gtest.h>

#include <pliant/error.hpp>

namespace pliant::test {
namespace {

using profile::seconds_of;

TEST(durations, have_a_unit) {
  EXPECT_DOUBLE_EQ(seconds_of("16.7ms", "--budget"), 16.7e-3);
  EXPECT_DOUBLE_EQ(seconds_of("800 us", "--budget"), 800e-6);
  EXPECT_EQ(seconds_of("2s", "--budget"), 2);
  EXPECT_EQ(seconds_of("2min", "--budget"), 120);
  EXPECT_EQ(seconds_of("1.5h", "--budget"), 5400);
}

TEST(durations, without_unit_or_sense_are_refused_with_an_example) {
  for (const char* text : {"16.7", "", "ms", "-1ms", "0s", "infs", "nans", "1 m s", "1sec"}) {
    try {
      seconds_of(text, "--budget");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(
          std::string(error.what()).find(std::string("--budget ") + text + ": not a duration"), 0u);
      EXPECT_NE(std::string(error.what()).find("16.7ms"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace pliant::test
