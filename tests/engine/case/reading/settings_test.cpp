#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

using tests::block_case;
using tests::complaint;
using tests::read_text;

const std::string walled_case = block_case + R"(velocity = [0, "y"]
[[boundary]]
name = "upper"
kind = "moving_wall"
geometry = { shape = "half_space", point = [0, 2], normal = [0, -1] }
velocity = [0, -25]
)";

TEST(settings, override_the_file) {
  const Case a_case = read_text(walled_case, {"discretisation.spacing=0.05", "time.end=2"});
  EXPECT_EQ(a_case.discretisation.spacing, 0.05);
  EXPECT_EQ(a_case.time.end, 2);
}

TEST(settings, add_what_the_file_does_not_say) {
  const Case a_case = read_text(walled_case, {"ghosts.treatment=averaged", "title=a = b, \"c\""});
  EXPECT_EQ(a_case.ghosts, GhostTreatment::averaged);
  EXPECT_EQ(a_case.title, "a = b, \"c\"");
}

TEST(settings, plain_words_need_no_quotes) {
  EXPECT_EQ(*read_text(walled_case, {"time.step=0.01"}).time.step, 0.01);
  EXPECT_FALSE(read_text(walled_case, {"time.step=0.01", "time.step=cfl"}).time.step.has_value());
  EXPECT_FALSE(read_text(walled_case, {"time.step=\"cfl\""}).time.step.has_value());
}

TEST(settings, formulas_need_no_quotes) {
  EXPECT_EQ(read_text(walled_case, {"discretisation.spacing=1/32"}).discretisation.spacing,
            1.0 / 32);
}

TEST(settings, reach_into_lists_by_name_and_by_position) {
  const Case by_name = read_text(walled_case, {"boundary.upper.velocity=[0, \"-t\"]"});
  EXPECT_EQ(by_name.boundaries.at(0).velocity[1](3), -3);
  const Case by_position =
      read_text(walled_case, {"body.0.material.youngs_modulus=200", "boundary.0.velocity.1=-7"});
  EXPECT_EQ(by_position.bodies.at(0).material_as_given.youngs_modulus, 200);
  EXPECT_EQ(by_position.boundaries.at(0).velocity[1](0), -7);
}

TEST(settings, the_last_one_wins) {
  EXPECT_EQ(read_text(walled_case, {"time.end=2", "time.end=3"}).time.end, 3);
}

TEST(settings, are_checked_like_the_file_and_named_in_messages) {
  EXPECT_EQ(complaint(walled_case, {"time.end=-1"}),
            "--set time.end=-1: end must be positive, got -1; write it as in end = 0.02");
  EXPECT_EQ(complaint(walled_case, {"time.endd=1"}),
            "--set time.endd=1: unknown key `endd` in [time]; did you mean `end`?");
  EXPECT_EQ(complaint(walled_case, {"tiem.end=1"}),
            "--set tiem.end=1: unknown key `tiem` in the case; did you mean `time`?");
}

TEST(settings, wrong_ones_are_explained) {
  EXPECT_EQ(
      complaint(walled_case, {"time.end"}),
      "--set time.end: a setting must have the form key=value; write it as in --set time.end=0.01");
  EXPECT_EQ(complaint(walled_case, {"boundary.uper.velocity=[0,0]"}),
            "--set boundary.uper.velocity=[0,0]: `boundary` has no element `uper`; did you mean "
            "`upper`?");
  EXPECT_EQ(complaint(walled_case, {"body.3.name=a"}),
            "--set body.3.name=a: `body` has no element `3`; it has block");
  EXPECT_EQ(complaint(walled_case, {"time.end.soon=1"}),
            "--set time.end.soon=1: `time.end` is 1, not a table; set `time.end` as a whole");
  const std::string of_named_material = complaint(
      "[[body]]\nname = \"block\"\nmaterial = \"rubber\"\n", {"body.block.material.density=1"});
  EXPECT_NE(
      of_named_material.find(
          "--set body.block.material.density=1: `body.block.material` is the text \"rubber\", "
          "not a table; set `body.block.material` as a whole, or `material.rubber.density`"),
      std::string::npos)
      << of_named_material;
  EXPECT_EQ(
      complaint(walled_case, {"boundary.upper.velocity=[0, 1"}),
      "--set boundary.upper.velocity=[0, 1: the value is not TOML: Error while parsing array: "
      "encountered end-of-file; close every bracket and quote, and quote the whole argument "
      "in the shell");
}

}  // namespace
}  // namespace pliant
