#include "engine/simulation/passing_bodies.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

/// Two discs 0.1 m apart that approach each other by 2 m each second.
std::unique_ptr<Solver> discs(const std::string& method, const std::string& contact) {
  std::string text = tests::rubber_case(method, 2, "0.1", "1") + contact;
  for (const std::string name : {"left", "right"}) {
    const std::string sign = name == "left" ? "-" : "", other = name == "left" ? "" : "-";
    text += "[[body]]\nname = \"" + name +
            "\"\nmaterial = \"rubber\"\ngeometry = { shape = \"disc\", centre = [" + sign +
            "0.55, 0], radius = 0.5 }\nvelocity = [" + other + "1, 0]\n";
  }
  return methods().make(tests::read_text(text), {});
}

TEST(passing_bodies, are_named_once_they_are_inside_each_other) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const auto run = discs(method, "");
    EXPECT_EQ(passing_bodies_warning(*run), "");
    run->advance(0.04);
    EXPECT_EQ(passing_bodies_warning(*run), "") << method;
    run->advance(0.2);
    const std::string warning = passing_bodies_warning(*run);
    EXPECT_NE(warning.find("bodies `left` and `right` pass through each other"), warning.npos)
        << method << warning;
  }
}

TEST(passing_bodies, with_a_contact_are_none) {
  const auto run = discs("total_lagrangian", "[[contact]]\nbodies = [\"right\", \"left\"]\n");
  run->advance(0.2);
  EXPECT_EQ(passing_bodies_warning(*run), "");
}

/// A hairpin, of which a wall moves one arm towards the other, 0.4 m away, by `way` [m].
std::unique_ptr<Solver> hairpin(const std::string& method, double way) {
  const std::string text = tests::rubber_case(method, 2, "0.1", "1") + R"([[body]]
name = "pin"
material = "rubber"
geometry = { shape = "difference", of = [
  { shape = "box", lower = [0, 0], upper = [2, 1] },
  { shape = "box", lower = [0.5, 0.3], upper = [3, 0.7] },
] }
[[boundary]]
name = "held"
kind = "fixed"
geometry = { shape = "box", lower = [1.8, -1], upper = [3, 0.1] }
[[boundary]]
name = "moved"
kind = "moving_wall"
geometry = { shape = "box", lower = [1.8, 0.9], upper = [3, 2] }
displacement = [0, "-)" + std::to_string(way) +
                           "*t\"]\n";
  return methods().make(tests::read_text(text), {});
}

TEST(passing_parts, are_named_once_they_are_inside_each_other) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const auto near = hairpin(method, 0.3), through = hairpin(method, 0.6);
    near->advance(1);
    EXPECT_EQ(passing_parts_warning(*near), "") << method;
    through->advance(1);
    const std::string warning = passing_parts_warning(*through);
    EXPECT_NE(warning.find("parts of body `pin` pass through each other"), warning.npos) << method;
    EXPECT_NE(warning.find("bodies = [\"pin\", \"pin\"]"), warning.npos) << warning;
  }
}

}  // namespace
}  // namespace pliant::test
