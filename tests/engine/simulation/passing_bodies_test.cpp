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
  std::string text = "method = \"" + method + R"("
dimension = 2
discretisation = { spacing = 0.1 }
time = { end = 1 }
[material.rubber]
model = "neo_hookean"
density = 1
youngs_modulus = 100
poissons_ratio = 0.3
)" + contact;
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

}  // namespace
}  // namespace pliant::test
