#include "engine/remeshed/observe/surface_mesh.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>

#include "engine/remeshed/observe/integrals.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/spinning_disc.hpp"

namespace pliant::test {
namespace {

using Place = Eigen::Vector3d;

// Centre and spacing as users give them, so that some nodes are on the surface.
constexpr const char* ball = R"(
dimension = 3
discretisation = { spacing = 0.2 }
time = { end = 1 }
remeshing = { every = 3 }
[[body]]
name = "ball"
geometry = { shape = "ball", centre = [0, 0, 0], radius = 1 }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
rotation = { centre = [0, 0, 0], angular_velocity = [2, 4, 6] }
)";

using Solver3 = remeshed::Solver<double, 3>;

remeshed::ExtractedSurface<3> surface_of(Solver3& solver) {
  return remeshed::surface_mesh<double, 3>(solver.on_nodes()[0], solver.state().boundaries);
}

Place place(const remeshed::SurfaceVertex<3>& v) { return {v.place[0], v.place[1], v.place[2]}; }

/// Volume that the triangles enclose, by the divergence theorem.
double enclosed_volume(const remeshed::ExtractedSurface<3>& surface) {
  double sum = 0;
  for (const auto& piece : surface.pieces) {
    const Place a = place(surface.vertices[piece[0]]), b = place(surface.vertices[piece[1]]),
                c = place(surface.vertices[piece[2]]);
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

/// Every edge belongs to two triangles, which pass it in opposite directions, and by Euler's
/// formula the surface is a sphere.
void expect_sphere(const remeshed::ExtractedSurface<3>& surface) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
  for (const auto& piece : surface.pieces) {
    for (int i = 0; i < 3; ++i) ++edges[{piece[i], piece[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
  const auto count = [](const auto& all) { return static_cast<std::int64_t>(all.size()); };
  EXPECT_EQ(count(surface.vertices) - count(edges) / 2 + count(surface.pieces), 2);
}

TEST(surface_mesh, of_a_ball_is_closed_and_holds_its_volume) {
  double error[2];
  for (const int fine : {0, 1}) {
    Solver3 solver(tests::read_text(
                       ball, {fine ? "discretisation.spacing=0.1" : "discretisation.spacing=0.2"}),
                   {1, kernels::Isa::sse2});
    const auto surface = surface_of(solver);
    expect_sphere(surface);
    error[fine] = 1 - enclosed_volume(surface) / (4 * pi / 3);
  }
  // Zeros and flat triangles are up to (3/8 + 3/8) h^2 inside; for the volume three times that.
  EXPECT_GT(error[0], 0);
  EXPECT_LT(error[0], 3 * 0.75 * 0.2 * 0.2);
  EXPECT_NEAR(error[0] / error[1], 4, 0.6);
}

TEST(surface_mesh, stays_closed_while_the_ball_turns_and_breathes) {
  Solver3 solver(tests::read_text(ball), {1, kernels::Isa::sse2});
  for (int step = 0; step < 7; ++step) solver.step(HUGE_VAL);
  EXPECT_GE(solver.clock().remeshings, 2);
  const auto surface = surface_of(solver);
  expect_sphere(surface);
  const auto views = solver.on_nodes();
  const double volume =
      remeshed::integrate<double, 3>(views[0], solver.state().boundaries, {}).volume;
  EXPECT_NEAR(enclosed_volume(surface) / volume, 1, 3 * 0.75 * 0.2 * 0.2);
}

TEST(surface_mesh, of_a_block_between_walls_is_closed_and_holds_its_volume) {
  for (const char* kind : {"fixed", "contact_wall"}) {
    const std::string walls = fmt::format(R"(
dimension = 3
discretisation = {{ spacing = 0.1 }}
time = {{ end = 1 }}
[[body]]
name = "block"
geometry = {{ shape = "box", lower = [0, 0, 0], upper = [1, 1, 0.6] }}
material = {{ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}
[[boundary]]
name = "floor"
kind = "{0}"
geometry = {{ shape = "half_space", point = [0, 0, 0], normal = [0, 0, 1] }}
[[boundary]]
name = "side"
kind = "{0}"
geometry = {{ shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }}
)",
                                          kind);
    Solver3 solver(tests::read_text(walls), {1, kernels::Isa::sse2});
    const auto surface = surface_of(solver);
    expect_sphere(surface);
    // Marching tetrahedra cut off the edges, whose total length is 10.4, at half a spacing.
    EXPECT_NEAR(enclosed_volume(surface), 0.6, 10.4 * 0.1 * 0.1 / 2) << kind;
  }
}

TEST(surface_mesh, of_a_periodic_body_ends_with_the_period) {
  Solver3 solver(tests::read_text(R"(
dimension = 3
discretisation = { spacing = 0.1 }
time = { end = 1 }
[periodic]
axes = ["x", "y", "z"]
lower = [0, 0, 0]
upper = [1, 1, 1]
[[body]]
name = "medium"
geometry = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
)"),
                 {1, kernels::Isa::sse2});
  const auto surface = surface_of(solver);
  expect_sphere(surface);
  EXPECT_NEAR(enclosed_volume(surface), 1, 12 * 0.1 * 0.1 / 2);
  for (const auto& v : surface.vertices) {
    const double farthest = std::max(
        {std::abs(v.place[0] - 0.5), std::abs(v.place[1] - 0.5), std::abs(v.place[2] - 0.5)});
    EXPECT_NEAR(farthest, 0.5, 0.06);
  }
}

TEST(surface_mesh, carries_linear_fields_exactly) {
  Solver3 solver(tests::read_text(ball), {1, kernels::Isa::sse2});
  const auto views = solver.on_nodes();
  const Place omega(2, 4, 6);
  for (const auto& v :
       remeshed::surface_mesh<double, 3>(views[0], solver.state().boundaries).vertices) {
    const Place exact = omega.cross(place(v));
    for (int a = 0; a < 3; ++a) {
      ASSERT_NEAR(v.interpolated(views[0].fields.get(Field::velocity, a)), exact[a], 1e-13);
    }
  }
}

TEST(surface_mesh, of_a_disc_is_one_loop_with_the_body_to_its_left) {
  Solver solver(spinning_disc(0.1), {1, kernels::Isa::sse2});
  const auto surface =
      remeshed::surface_mesh<double, 2>(solver.on_nodes()[0], solver.state().boundaries);
  std::map<std::int64_t, std::int64_t> next;
  double area = 0;
  for (const auto& [from, to] : surface.pieces) {
    EXPECT_TRUE(next.emplace(from, to).second);
    const auto &a = surface.vertices[from].place, &b = surface.vertices[to].place;
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  std::size_t length = 1;
  for (std::int64_t v = next.at(0); v != 0; v = next.at(v)) ++length;
  EXPECT_EQ(length, surface.vertices.size());
  EXPECT_EQ(length, surface.pieces.size());
  // Zeros and chords are up to (2/8 + 2/8) h^2 inside; for the area twice that.
  EXPECT_LT(area, pi);
  EXPECT_GT(area, pi * (1 - 2 * 0.5 * 0.1 * 0.1));
}

}  // namespace
}  // namespace pliant::test
