#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/undeformed/loads.hpp"

// A uniform tension on one face of a cube: its corners and the ends of planes of symmetry move as
// far as its middle.
namespace pliant::test {
namespace {

constexpr double tensile_strain = 0.5 / 100;

/// An eighth of a larger cube, between three planes of symmetry.
std::string cube(const std::string& geometry, const std::string& nodes) {
  std::string text = R"(method = "point_based"
dimension = 3
discretisation = { spacing = 0.1 }
time = { end = 3 }
[point_based]
damping = 5
nodes = ")" + nodes + R"("
[[body]]
name = "cube"
material = { model = "neo_hookean", density = 1, youngs_modulus = 100, poissons_ratio = 0.3 }
geometry = )" + geometry +
                     "\n" + half_space("x", "kind = \"slip_wall\"", "[0, 0, 0]", "[1, 0, 0]") +
                     half_space("y", "kind = \"slip_wall\"", "[0, 0, 0]", "[0, 1, 0]") +
                     half_space("z", "kind = \"slip_wall\"", "[0, 0, 0]", "[0, 0, 1]") +
                     half_space("pull", "kind = \"pressure\"\npressure = \"-0.5*min(t, 1)\"",
                                "[0.999, 0, 0]", "[-1, 0, 0]");
  for (const std::string place : {"[1, 0, 0]", "[1, 1, 0]", "[1, 0, 1]", "[1, 1, 1]"}) {
    text += measurement(fmt::format("corner_{}_{}", place[4], place[7]),
                        "kind = \"point_displacement\"\naxis = \"x\"\npoint = " + place);
  }
  return text;
}

void expect_equal_displacements(const std::string& text) {
  const auto run = methods().make(tests::read_text(text), {2});
  run->advance(3);
  for (const auto& [name, moved] : values(*run)) {
    EXPECT_NEAR(moved, tensile_strain, 0.015 * tensile_strain) << name;
  }
}

// They moved by 1.062, 0.959 and 1.044 times as far: by its triangles, a rectangle of the face gave
// a third or a sixth of its load to a corner.
TEST(loaded_corners, of_a_lattice_move_as_far_as_the_face) {
  expect_equal_displacements(
      cube("{ shape = \"box\", lower = [0, 0, 0], upper = [1, 1, 1] }", "lattice"));
}

// The end of the edge between two planes of symmetry moved by 1.046 and 1.079 times as far: the
// weights of its nodes were not balanced along this edge.
TEST(loaded_corners, of_an_octree_and_of_a_mesh_do_so_too) {
  expect_equal_displacements(
      cube("{ shape = \"box\", lower = [0, 0, 0], upper = [1, 1, 1] }", "octree"));
  const TemporaryFolder folder;
  const auto mesh = folder.path() / "cube.vtk";
  write(BlockMesh<3>{{10, 10, 10}, {0, 0, 0}, {1, 1, 1}, 0.1}, mesh);
  expect_equal_displacements(
      cube(fmt::format("{{ shape = \"mesh\", file = \"{}\" }}", mesh.string()), "lattice"));
}

}  // namespace
}  // namespace pliant::test
