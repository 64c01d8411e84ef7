#include "engine/case/writing/resolved.hpp"

#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

using tests::block_case;
using tests::read_text;

const std::string rich_case = R"toml(
title = "quotes \" and \\ and\ttabs"
name = "rich"
[discretisation]
spacing = "1/30"
kernel = "quartic_spline"
dissipation = { velocity = 0.3, stress = 0.1 }
[time]
end = 0.3
step = 1e-4
cfl = 0.3
strain = 0.05
[remeshing]
every = 7
strain_threshold = 0.1
deformation_threshold = 0.15
filter = 0.05
volume = "conserved"
[level_set]
reinitialise_every = 11
[ghosts]
treatment = "rigid"
[periodic]
axes = ["x"]
lower = [-1, -inf]
upper = [1, inf]
[[body]]
name = "soft"
geometry = { shape = "difference", of = [{ shape = "box", lower = [-inf, 0], upper = [inf, 1] }, { shape = "disc", centre = [0, 0.5], radius = 0.2 }] }
material = { model = "reduced_polynomial", coefficients = [2.2, 0.1], compressibility = 0.001, density = 3 }
rotation = { centre = [0.1, 0.5], angular_velocity = 0.7 }
[[body]]
name = "hard"
geometry = { shape = "intersection", of = [{ shape = "box", lower = [-0.5, 2], upper = [0.5, 3] }, { shape = "half_space", point = [0, 2.5], normal = [1, 3] }] }
material = { model = "linear", equation_of_state = "logarithmic", youngs_modulus = 0.1, poissons_ratio = 0.3, density = 1 }
velocity = ["sin(y)", 1]
[[boundary]]
name = "lid"
kind = "moving_wall"
geometry = { shape = "half_space", point = [0, 3], normal = [0, -1] }
velocity = [0, "-t"]
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "side"
kind = "slip_wall"
geometry = { shape = "half_space", point = [-0.5, 0], normal = [1, 0] }
velocity = [0.5, 0]
[[boundary]]
name = "air"
kind = "pressure"
geometry = { shape = "union", of = [{ shape = "disc", centre = [0, 2], radius = 1 }, { shape = "disc", centre = [1, 2], radius = 1 }] }
pressure = "3*t"
[output]
every = 0.01
checkpoint_every = 0.1
ghosts = true
measure_every = 0.001
[[measurement]]
name = "bulge"
kind = "extent"
body = "hard"
axis = "y"
side = "lower"
where = "x > 0"
reference = 0.5
[[measurement]]
name = "beat"
kind = "amplitude_ratio"
of = "bulge"
[[measurement]]
name = "reach"
kind = "surface_distance"
point = [0, 2.5]
direction = [1, 2]
[[measurement]]
name = "error"
kind = "velocity_error"
exact = ["x*t", 0]
reference = 2
norm = "root_mean_square"
[[measurement]]
name = "pressure"
kind = "point_value"
field = "pressure"
point = [0.1, 2.2]
)toml";

TEST(resolved, it_holds_every_default) {
  EXPECT_EQ(resolved_toml(read_text(block_case)), R"(title = "a block"
name = "block"
dimension = 2
method = "remeshed"
precision = "double"
gravity = [0, 0]

[discretisation]
spacing = 0.1
damping = 0
kernel = "compact"
dissipation = { velocity = 0.5, stress = 0.025 }

[time]
end = 1
step = "cfl"
cfl = 1
strain = 0.02

[remeshing]
every = "adaptive"
strain_threshold = 0.18
deformation_threshold = 0.2
filter = 0
volume = "reset"

[level_set]
reinitialise_every = 20

[ghosts]
treatment = "linear"

[remeshed]
gradient = "moment_matrix"
reinitialisation = "closest_point"
determinant = "from_density"
free_motion = "kept"
mass_scaling = 1

[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 2] }
material = { model = "linear", density = 2, equation_of_state = "linear", youngs_modulus = 100, poissons_ratio = 0.3 }
velocity = [0, 0]
stretch = [1, 1]

[output]
every = 0
checkpoint_every = 0
ghosts = false
surface = false
measure_every = 0

[checks]
energy = "warn"
mass = "warn"
momentum = "warn"
)");
}

/// Compares every value that the case above sets, bit by bit.
void expect_equal(const Shape& a, const Shape& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.lower, b.lower);
  EXPECT_EQ(a.upper, b.upper);
  EXPECT_EQ(a.centre, b.centre);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.normal, b.normal);
  ASSERT_EQ(a.operands.size(), b.operands.size());
  for (std::size_t i = 0; i < a.operands.size(); ++i) expect_equal(a.operands[i], b.operands[i]);
}

void expect_equal(const MeasurementCase& a, const MeasurementCase& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.body, b.body);
  EXPECT_EQ(a.axis, b.axis);
  EXPECT_EQ(a.lower_side, b.lower_side);
  EXPECT_EQ(a.where.has_value(), b.where.has_value());
  EXPECT_EQ(a.reference, b.reference);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.field, b.field);
  EXPECT_EQ(a.norm, b.norm);
  EXPECT_EQ(a.of, b.of);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(a.exact[i].text(), b.exact[i].text());
}

TEST(resolved, reading_it_gives_an_equal_case) {
  const Case original = read_text(rich_case);
  const std::string text = resolved_toml(original);
  const Case again = read_text(text);
  EXPECT_EQ(again.title, original.title);
  EXPECT_EQ(again.name, "rich");
  EXPECT_EQ(again.discretisation.spacing, original.discretisation.spacing);
  EXPECT_EQ(again.time.step, original.time.step);
  EXPECT_EQ(again.periodic.axis, original.periodic.axis);
  EXPECT_EQ(again.periodic.lower, original.periodic.lower);
  ASSERT_EQ(again.bodies.size(), original.bodies.size());
  for (std::size_t i = 0; i < original.bodies.size(); ++i) {
    expect_equal(again.bodies[i].geometry, original.bodies[i].geometry);
    EXPECT_EQ(again.bodies[i].material.bulk_modulus, original.bodies[i].material.bulk_modulus);
    EXPECT_EQ(again.bodies[i].material.coefficient, original.bodies[i].material.coefficient);
    EXPECT_EQ(again.bodies[i].material.model, original.bodies[i].material.model);
    EXPECT_EQ(again.bodies[i].velocity.rotation.has_value(),
              original.bodies[i].velocity.rotation.has_value());
  }
  ASSERT_EQ(again.boundaries.size(), original.boundaries.size());
  for (std::size_t i = 0; i < original.boundaries.size(); ++i) {
    expect_equal(again.boundaries[i].geometry, original.boundaries[i].geometry);
    EXPECT_EQ(again.boundaries[i].kind, original.boundaries[i].kind);
    EXPECT_EQ(again.boundaries[i].pressure.text(), original.boundaries[i].pressure.text());
    EXPECT_EQ(again.boundaries[i].velocity[1].text(), original.boundaries[i].velocity[1].text());
  }
  ASSERT_EQ(again.measurements.size(), original.measurements.size());
  for (std::size_t i = 0; i < original.measurements.size(); ++i) {
    expect_equal(again.measurements[i], original.measurements[i]);
  }
  EXPECT_EQ(resolved_toml(again), text);
}

// Each setting changes the resolved text: no key is read without being written.
TEST(resolved, no_setting_is_lost) {
  const std::string before = resolved_toml(read_text(rich_case));
  for (const char* setting : {"title=b",
                              "name=b",
                              "discretisation.spacing=0.05",
                              "discretisation.kernel=compact",
                              "discretisation.dissipation.velocity=1",
                              "discretisation.dissipation.stress=1",
                              "time.end=4",
                              "time.step=cfl",
                              "time.cfl=0.1",
                              "time.strain=0.1",
                              "remeshing.every=never",
                              "remeshing.strain_threshold=0.3",
                              "remeshing.deformation_threshold=0.3",
                              "remeshing.filter=0",
                              "remeshing.volume=reset",
                              "level_set.reinitialise_every=5",
                              "ghosts.treatment=linear",
                              "output.every=0",
                              "output.ghosts=false",
                              "output.checkpoint_every=2",
                              "output.measure_every=3",
                              "measurement.bulge.side=upper",
                              "measurement.bulge.where=x<0",
                              "measurement.bulge.body=soft",
                              "measurement.error.norm=maximum",
                              "body.hard.material.equation_of_state=linear",
                              "body.soft.rotation.angular_velocity=3",
                              "boundary.air.pressure=t",
                              "periodic.upper=[3, inf]"}) {
    EXPECT_NE(resolved_toml(read_text(rich_case, {setting})), before) << setting;
  }
}

}  // namespace
}  // namespace pliant
