#include <gtest/gtest.h>

#include <memory>

#include "tests/engine/remeshed/snapshot.hpp"

// The laws of motion do not depend on place or direction; a lattice has the symmetry of quarter
// turns.
namespace pliant::test {
namespace {

std::unique_ptr<Solver> after(const Case& settings, int steps) {
  auto solver = std::make_unique<Solver>(settings, SolverOptions{1, kernels::widest_supported()});
  advance(*solver, steps);
  return solver;
}

// Coordinates of size 4 are rounded to 4e-16, which is 1e-14 of a spacing. The slopes of level set
// and walls propagate this, and 20 steps of a few dozen sums each add to it.
constexpr double rounding = 1e-11;
// The cubic interpolant of the level set is continuous, but its slope is not: on lattice lines,
// where the closest points of plane surfaces are, rounding decides which of the two slopes turns
// the foot point. Near corners that is 2e-6 spacings, and ten times as much in stresses.
constexpr double closest_points = 2e-5;

const Settings disc = {"discretisation.spacing=1/16", "time.step=1e-3", "remeshing.every=6"};
const Settings block = {"discretisation.spacing=1/16", "time.step=5e-5",
                        "remeshing.strain_threshold=0.015"};

void expect_same_particles(const Solver& a, const Solver& b) {
  EXPECT_GE(a.clock().remeshings, 2);
  const Snapshot x = snapshot_of(a, Slots::particles), y = snapshot_of(b, Slots::particles);
  EXPECT_EQ(x.at("cell"), y.at("cell")) << "cells count from the middle of the body";
  for (const remeshed::Declaration& field : remeshed::state_fields) {
    EXPECT_LT(relative_difference(x, y, std::string(field.name)), rounding) << field.name;
  }
}

TEST(symmetry, a_translated_disc_does_the_same) {
  const Settings there = {
      R"(body.cylinder.geometry={ shape = "disc", centre = [3.3, -1.7], radius = 1 })",
      R"(body.cylinder.rotation={ centre = [3.3, -1.7], angular_velocity = "2*pi" })"};
  expect_same_particles(*after(small_case("rotating_cylinder", disc), 20),
                        *after(small_case("rotating_cylinder", disc + there), 20));
}

TEST(symmetry, a_translated_compression_does_the_same) {
  const Settings there = {
      R"(body.block.geometry={ shape = "box", lower = [2.8, -3.1], upper = [3.8, -1.1] })",
      R"--(body.block.velocity=[0, "-25*(y + 2.1)"])--",
      R"(boundary.upper.geometry={ shape = "half_space", point = [0, -1.1], normal = [0, -1] })",
      R"(boundary.lower.geometry={ shape = "half_space", point = [0, -3.1], normal = [0, 1] })"};
  expect_same_particles(*after(small_case("compression_linear", block), 25),
                        *after(small_case("compression_linear", block + there), 25));
}

/// A quarter turn about the origin of the lattice: (x, y) -> (-y, x).
Cell<2> turned(const Cell<2>& cell) { return {-1 - cell[1], cell[0]}; }

/// The components of a field after a quarter turn.
std::vector<double> turned(const std::vector<double>& f) {
  switch (f.size()) {
    case 2:
      return {-f[1], f[0]};
    case 3:
      return {f[2], -f[1], f[0]};  // xx, xy, yy
    case 4:
      return {f[3], -f[2], -f[1], f[0]};  // row by row
    default:
      return f;
  }
}

std::vector<double> values(const Body& body, Field field, std::int64_t slot) {
  std::vector<double> values;
  for (const Buffer<double>& component : body.stage[0][field]) values.push_back(component[slot]);
  return values;
}

void expect_turned_particles(const Solver& a, const Solver& b, double tolerance) {
  const Body &body = a.state().bodies[0], &other = b.state().bodies[0];
  EXPECT_EQ(body.population.particles, other.population.particles);
  for (const remeshed::Declaration& field : remeshed::state_fields) {
    double size = 0, difference = 0;
    for_each(body.population, Kind::interior, [&](std::int64_t slot, const Cell<2>& cell) {
      const std::int64_t there = other.population.layout.slot(turned(cell));
      ASSERT_GE(there, 0);
      ASSERT_EQ(other.population.kind[there], Kind::interior);
      const std::vector<double> expected = turned(values(body, field.field, slot));
      const std::vector<double> found = values(other, field.field, there);
      for (std::size_t c = 0; c < found.size(); ++c) {
        size = std::max(size, std::abs(found[c]));
        difference = std::max(difference, std::abs(found[c] - expected[c]));
      }
    });
    EXPECT_LE(difference, tolerance * size) << field.name;
  }
}

TEST(symmetry, a_spinning_disc_stays_like_itself_a_quarter_turn_on) {
  const auto solver = after(small_case("rotating_cylinder", disc), 20);
  EXPECT_EQ(solver->clock().remeshings, 3);
  expect_turned_particles(*solver, *solver, closest_points);
}

TEST(symmetry, a_compression_along_x_is_one_along_y_turned) {
  const Settings turned_block = {
      R"(body.block.geometry={ shape = "box", lower = [-1, -0.5], upper = [1, 0.5] })",
      R"(body.block.velocity=["-25*x", 0])",
      R"(boundary.upper.geometry={ shape = "half_space", point = [1, 0], normal = [-1, 0] })",
      R"(boundary.lower.geometry={ shape = "half_space", point = [-1, 0], normal = [1, 0] })",
      "boundary.upper.velocity=[-25, 0]",
      "boundary.lower.velocity=[25, 0]"};
  for (const char* name : {"compression_linear", "compression_hyperelastic"}) {
    SCOPED_TRACE(name);
    const Case along_y = small_case(name, block), along_x = small_case(name, block + turned_block);
    const auto a = after(along_y, 8), b = after(along_x, 8);
    ASSERT_EQ(a->clock().remeshings, 0);
    expect_turned_particles(*a, *b, rounding);
    for (Solver* solver : {a.get(), b.get()}) advance(*solver, 17);
    ASSERT_GE(a->clock().remeshings, 2);
    expect_turned_particles(*a, *b, closest_points);
  }
}

}  // namespace
}  // namespace pliant::test
