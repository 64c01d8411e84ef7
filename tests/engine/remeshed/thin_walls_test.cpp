#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Walls that are thinner than the ghosts behind them are deep, and bodies that do not quite reach
// a wall, or reach into it.
namespace pliant::test {
namespace {

const std::string half_space_below = "{ shape = \"half_space\", point = [0, 0], normal = [0, 1] }";

std::string plate(double thickness) {
  return fmt::format("{{ shape = \"box\", lower = [-1, {}], upper = [2, 0] }}", -thickness);
}

/// A block of 1 m by 2 m, eight spacings across, of which the lower side is at `lower` spacings.
std::string block(double lower) {
  return fmt::format(R"toml(discretisation = {{ spacing = 0.125, damping = "adaptive" }}
time.end = 3
[[body]]
name = "block"
geometry = {{ shape = "box", lower = [0, {}], upper = [1, 2] }}
material = {{ model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
)toml",
                     lower / 8);
}

std::string wall(const std::string& kind, const std::string& geometry) {
  return fmt::format("[[boundary]]\nname = \"wall\"\n{}\ngeometry = {}\n", kind, geometry);
}

/// How far the upper end of a clamped block sways under its weight.
double sway(double lower, const std::string& geometry) {
  return values_at_end("gravity = [\"0.2*min(t, 1)\", 0]\n" + block(lower) +
                       wall("kind = \"fixed\"", geometry) +
                       measurement("sway", "kind = \"point_displacement\"\npoint = [0.5, 1.9]"))[0];
}

// Behind a plate of two spacings there used to be as much of the body again.
TEST(thin_walls, hold_a_body_as_thick_ones_do) {
  const double thick = sway(0, half_space_below);
  for (const double thickness : {0.9, 0.25, 0.05}) {
    EXPECT_DOUBLE_EQ(sway(0, plate(thickness)), thick) << thickness;
  }
}

// A floor of 1.6 spacings took half of the weight, and one of 0.8 spacings let the block through.
TEST(thin_walls, carry_a_body_as_thick_ones_do) {
  const auto impulse = [](const std::string& geometry) {
    return values_at_end(
        "gravity = [0, \"-20*min(t, 1)\"]\n" + block(0) +
        wall("kind = \"contact_wall\"\nfriction = 0.3", geometry) +
        measurement("impulse", "kind = \"wall_force\"\nboundary = \"wall\"\naxis = \"y\""))[0];
  };
  const double thick = impulse(half_space_below);
  EXPECT_NEAR(thick / 40, 2.45, 0.05);  // [s]
  for (const double thickness : {0.2, 0.1}) {
    EXPECT_DOUBLE_EQ(impulse(plate(thickness)), thick) << thickness;
  }
}

// A gap of a millionth of a spacing made the block seven times as soft, and a side inside the wall
// made it stiffer by 5 %.
TEST(walls_near_bodies, hold_them_as_if_they_touched) {
  const double touching = sway(0, half_space_below);
  for (const double lower : {-1.5, -0.8, 1e-6, 0.1, 0.45}) {
    EXPECT_NEAR(sway(lower, half_space_below), touching, 0.007 * touching) << lower;
  }
}

// Ghosts below the edges of a plate as wide as the block belonged to the sides of the plate, which
// bore about 0.55 of its force.
TEST(plates, as_wide_as_a_body_bear_the_whole_force) {
  const auto impulse = [](const std::string& geometry) {
    return values_at_end(
        block(0) +
        wall("kind = \"moving_wall\"\ndisplacement = [0, \"-0.02*min(t, 1)\"]", geometry) +
        half_space("top", "kind = \"fixed\"", "[0, 2]", "[0, -1]") +
        measurement("impulse", "kind = \"wall_force\"\nboundary = \"wall\"\naxis = \"y\""))[0];
  };
  const double endless = impulse(half_space_below);
  EXPECT_GT(std::abs(endless), 20);
  for (const double beside : {0., 0.03}) {
    const double plate = impulse(fmt::format(
        "{{ shape = \"box\", lower = [{}, -0.5], upper = [{}, 0] }}", -beside, 1 + beside));
    EXPECT_NEAR(plate, endless, 1e-3 * std::abs(endless)) << beside;
  }
}

std::vector<std::string> warnings_of(const std::string& text) {
  const Case settings = tests::read_text(text);
  return warnings_of_method(settings);
}

TEST(thin_walls, between_bodies_are_warned_of) {
  const std::string upper = block(0);
  const auto lower = [](double thickness) {
    return fmt::format(R"toml([[body]]
name = "lower"
geometry = {{ shape = "box", lower = [0, -3], upper = [1, {}] }}
material = {{ model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
)toml",
                       -thickness);
  };
  const auto is_warned_of = [&](double thickness) {
    std::string text;
    for (const std::string& warning :
         warnings_of(upper + lower(thickness) + wall("kind = \"fixed\"", plate(thickness)))) {
      text += warning + "\n";
    }
    return text.find("`wall` is less than 4.2 spacings thick") != std::string::npos;
  };
  EXPECT_TRUE(is_warned_of(0.4));
  EXPECT_FALSE(is_warned_of(0.6));
}

}  // namespace
}  // namespace pliant::test
