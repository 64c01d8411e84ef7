#include "engine/point_based/observe/opened_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/point_based/blocks.hpp"

namespace pliant::point_based {
namespace {

using test::PointSolver;

/// A block that is torn apart along y = 0.53 for x < 0.6, as in a cut that has opened.
struct OpenedBlock {
  PointSolver<2> solver{tests::read_text(test::free_points(2)), {1, kernels::widest_supported()}};
  CutSurface<2> cut;
  SurfaceVertices vertices;

  OpenedBlock() {
    cut.add_station({{-0.2, 0.53}});
    cut.add_station({{0.6, 0.53}});
    auto& body = solver.state().bodies[0];
    body.for_each_node([&](std::int64_t slot) {
      const auto& x = body.start[slot];
      if (x[1] > 0.53) body.displacement[1][slot] = 0.2 * std::max(0., 0.6 - x[0]);
    });
    add_opened_surface<double, 2>(body, {&cut, 1}, 7, vertices);
  }

  std::array<double, 2> corner(std::size_t piece, int k) const {
    const auto v = static_cast<std::size_t>(vertices.vertex[2 * piece + k]);
    return {vertices.position[3 * v], vertices.position[3 * v + 1]};
  }
  std::array<double, 2> corner_before(std::size_t piece, int k) const {
    const auto v = static_cast<std::size_t>(vertices.vertex[2 * piece + k]);
    const auto x = corner(piece, k);
    return {x[0] - vertices.displacement[2 * v], x[1] - vertices.displacement[2 * v + 1]};
  }
};

TEST(opened_surface, has_both_faces_of_a_cut_inside_the_body) {
  const OpenedBlock block;
  double outer = 0, faces = 0;
  for (std::size_t p = 0; p < block.vertices.vertex.size() / 2; ++p) {
    const auto a = block.corner_before(p, 0), b = block.corner_before(p, 1);
    const bool is_face = std::abs(a[1] - 0.53) < 1e-9 && std::abs(b[1] - 0.53) < 1e-9;
    (is_face ? faces : outer) += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  // Corners of the block are cut off by up to half a spacing, and so is the part at the surface.
  EXPECT_NEAR(outer, 4, 0.4);
  EXPECT_NEAR(faces, 2 * 0.6, 2 * 0.125);
}

TEST(opened_surface, each_face_moves_with_its_own_side) {
  const OpenedBlock block;
  double highest_below = -1, lowest_above = 2;
  for (std::size_t p = 0; p < block.vertices.vertex.size() / 2; ++p) {
    const auto from = block.corner_before(p, 0), to = block.corner_before(p, 1);
    if (std::abs(from[1] - 0.53) > 1e-9 || std::abs(to[1] - 0.53) > 1e-9) continue;
    if (std::max(from[0], to[0]) > 0.35) continue;  // near the tip they meet
    // The body is on the left of a piece: the face below runs towards -x.
    const double y = (block.corner(p, 0)[1] + block.corner(p, 1)[1]) / 2;
    if (to[0] < from[0]) highest_below = std::max(highest_below, y);
    if (to[0] > from[0]) lowest_above = std::min(lowest_above, y);
  }
  // The bonds of this block are whole: gradients beside the cut see a little of the other side.
  EXPECT_LT(highest_below, 0.53 + 0.02);
  EXPECT_GT(lowest_above, 0.53 + 0.2 * 0.2);
}

TEST(opened_surface, names_the_body_of_each_vertex) {
  const OpenedBlock block;
  EXPECT_EQ(block.vertices.owner.size(), block.vertices.vertex.size());
  EXPECT_TRUE(std::all_of(block.vertices.owner.begin(), block.vertices.owner.end(),
                          [](std::int32_t owner) { return owner == 7; }));
}

TEST(opened_surface, is_that_of_frames_once_a_blade_has_cut) {
  const std::string blade = R"toml([[cut]]
name = "blade"
from = [-0.2, 0.53]
path = ["6e8*t", 0]
end = 2e-9
)toml";
  PointSolver<2> solver(tests::read_text(test::free_points(2) + blade, {"time.step=1e-9"}),
                        {1, kernels::widest_supported()});
  const auto pieces = [&] { return solver.frame({false, true}).surface->vertex.size() / 2; };
  const std::size_t before = pieces();
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  // The cut crosses the block in eight pieces or more, each with two faces.
  EXPECT_GE(pieces(), before + 2 * 8);
}

}  // namespace
}  // namespace pliant::point_based
