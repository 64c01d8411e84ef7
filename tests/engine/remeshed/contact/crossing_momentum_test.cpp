#include "engine/remeshed/contact/crossing_momentum.hpp"

#include <gtest/gtest.h>

namespace pliant::remeshed {
namespace {

ContactCase between(int first, int second) {
  ContactCase contact;
  contact.bodies = {first, second};
  return contact;
}

// A body that rests on a held one has lost its weight to it, whatever its areas add up to.
TEST(crossing_momentum, is_that_which_a_free_body_on_a_held_one_has_gained) {
  for (const bool free_first : {true, false}) {
    const std::vector<ContactCase> contacts = {free_first ? between(1, 0) : between(0, 1)};
    std::vector<Point<2>> impulses = {{0, free_first ? -1.08 : 1.08}};
    follow_free_bodies<2>(contacts, {{false, {5, 5}}, {true, {0, 1}}}, impulses);
    EXPECT_DOUBLE_EQ(impulses[0][1], free_first ? -1 : 1);
    EXPECT_DOUBLE_EQ(impulses[0][0], 0);
  }
}

TEST(crossing_momentum, between_two_free_or_two_held_bodies_is_that_of_their_tractions) {
  for (const bool free : {true, false}) {
    std::vector<Point<3>> impulses = {{0.2, 0, 1}};
    follow_free_bodies<3>({between(0, 1)}, {{free, {1, 0, 0}}, {free, {0, 0, 3}}}, impulses);
    EXPECT_EQ(impulses[0], (Point<3>{0.2, 0, 1}));
  }
}

// A beam on two supports, and a body on top of it.
TEST(crossing_momentum, of_a_body_on_several_supports_adds_up_to_what_it_has_gained) {
  const std::vector<ContactCase> contacts = {between(0, 2), between(1, 2), between(3, 2),
                                             between(0, 3)};
  std::vector<Point<2>> impulses = {{0, 3}, {0, 1}, {0, -0.5}, {}};
  follow_free_bodies<2>(contacts, {{false, {}}, {false, {}}, {true, {0, 2}}, {true, {0, 0.4}}},
                        impulses);
  EXPECT_DOUBLE_EQ(impulses[0][1] + impulses[1][1] + impulses[2][1], 2);
  EXPECT_DOUBLE_EQ(impulses[0][1] / impulses[1][1], 3);
  EXPECT_EQ(impulses[2], (Point<2>{0, -0.5}));
  EXPECT_EQ(impulses[3], (Point<2>{}));
}

}  // namespace
}  // namespace pliant::remeshed
