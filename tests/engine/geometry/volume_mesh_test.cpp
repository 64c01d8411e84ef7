#include "engine/geometry/volume_mesh.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/geometry/closed_mesh.hpp"
#include "tests/engine/geometry/mesh_files/volume_mesh_files.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant {
namespace {

using namespace tests;

VolumeMesh read_volume(const std::string& name, const std::string& content, int dimension = 3) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << content;
  return read_volume_mesh(folder / name, dimension);
}

/// The error message for a wrong file, without the folder.
std::string answer(const std::string& name, const std::string& content, int dimension = 3) {
  try {
    read_volume(name, content, dimension);
  } catch (const MeshError& error) {
    const std::string what = error.what();
    return what.substr(what.find(name));
  }
  return "no error";
}

std::string changed(std::string content, const std::string& from, const std::string& to) {
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return content.replace(at, from.size(), to);
}

const std::vector<std::pair<const char*, std::string>> cubes = {
    {"a.msh", gmsh_2_text()},   {"b.msh", gmsh_2_binary()}, {"c.msh", gmsh_4_text()},
    {"d.MSH", gmsh_4_binary()}, {"e.vtk", vtk_text()},      {"f.vtk", vtk_binary()},
    {"g.vtk", vtk_5_text()}};

TEST(volume_mesh, every_format_gives_the_same_cube) {
  for (const auto& [name, content] : cubes) {
    const VolumeMesh mesh = read_volume(name, content);
    EXPECT_EQ(mesh.vertices.size(), 8u) << name;
    ASSERT_EQ(mesh.elements.size(), 6u) << name;
    for (std::size_t e = 0; e < 6; ++e) EXPECT_DOUBLE_EQ(element_volume(mesh, e), 1. / 6) << name;
  }
}

TEST(volume_mesh, its_boundary_encloses_the_same_volume) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "a.msh") << gmsh_4_text();
  const ClosedMesh surface(read_mesh(folder / "a.msh"), "a.msh");
  EXPECT_EQ(surface.triangles().size(), 12u);
  EXPECT_DOUBLE_EQ(surface.volume(), 1);
}

TEST(volume_mesh, a_2d_mesh_has_triangles) {
  const std::string square =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 2 0 0\n3 2 1 0\n4 0 1 0\n"
      "$EndNodes\n$Elements\n3\n1 1 0 1 2\n2 2 0 1 2 3\n3 2 0 1 3 4\n$EndElements\n";
  const VolumeMesh mesh = read_volume("a.msh", square, 2);
  ASSERT_EQ(mesh.elements.size(), 2u);
  EXPECT_DOUBLE_EQ(element_volume(mesh, 0) + element_volume(mesh, 1), 2);
  EXPECT_EQ(answer("a.msh", changed(square, "2 1 0\n", "2 1 3\n"), 2),
            "a.msh:8: a node has z = 3 in a 2D case");
  EXPECT_EQ(answer("a.msh", square), "a.msh: holds no tetrahedron");
}

TEST(volume_mesh, a_mesh_that_is_inverted_everywhere_is_turned) {
  std::string inverted = vtk_text();
  for (const auto& e : cube_elements) {
    inverted = changed(inverted, fmt::format("4 {} {} {} {}\n", e[0], e[1], e[2], e[3]),
                       fmt::format("4 {} {} {} {}\n", e[1], e[0], e[2], e[3]));
  }
  EXPECT_GT(element_volume(read_volume("a.vtk", inverted), 3), 0);
}

TEST(volume_mesh, wrong_meshes_are_refused_with_their_line) {
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "0 1 10 20 40 80", "0 1 20 10 40 80")),
            "a.msh:18: this tetrahedron is inverted: its volume is -0.166667");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "0 1 10 20 40 80", "0 1 10 20 30 40")),
            "a.msh:18: this tetrahedron is flat: its volume is 0");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "80 1 1 1", "80 1 1 0")),
            "a.msh:13: two nodes are at (1, 1, 0)");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "80 1 1 1", "70 1 1 1")),
            "a.msh:13: the number 70 has two nodes");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "80 1 1 1", "80 1 1 nan")),
            "a.msh:13: a coordinate is not finite, found \"nan\"");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "0 1 10 20 40 80", "0 1 10 20 40 90")),
            "a.msh:18: a tetrahedron has the node 90, which the file does not hold");
  EXPECT_EQ(
      answer("a.msh", changed(gmsh_2_text(), "3 4 2 0 1 10 40 30 80", "3 4 2 0 1 10 20 40 80")),
      "a.msh:23: this tetrahedron shares a facet with two others");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "2.2 0 8", "4 0 8")),
            "a.msh:2: version 4 of the format is not read");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "2 4 2 0 1 10", "2 11 2 0 1 1 2 3 4 5 6 10")),
            "a.msh:18: an element of the kind 11 cannot be read");
  EXPECT_EQ(answer("a.vtk", changed(vtk_text(), "CELL_TYPES 7\n5\n10", "CELL_TYPES 7\n5\n12")),
            "a.vtk:17: an element of the kind 12 cannot be read");
}

TEST(volume_mesh, numbers_of_rows_are_those_of_the_file) {
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "$Nodes\n8", "$Nodes\n9")),
            "a.msh:14: the number of a node must be a whole number, found \"$EndNodes\"");
  EXPECT_EQ(answer("a.msh", changed(gmsh_2_text(), "$Nodes\n8", "$Nodes\n7")),
            "a.msh:13: the section $Nodes has more rows than it announces");
  const std::string huge = "10000000000000000";
  EXPECT_THROW(read_volume("a.msh", changed(gmsh_2_text(), "$Elements\n7", "$Elements\n" + huge)),
               MeshError);
  EXPECT_THROW(read_volume("a.msh", changed(gmsh_2_binary(), "$Nodes\n8", "$Nodes\n" + huge)),
               MeshError);
  EXPECT_THROW(read_volume("a.msh", changed(gmsh_4_binary(), bytes(std::int64_t{8}),
                                            bytes(std::int64_t{1} << 60))),
               MeshError);
  EXPECT_THROW(read_volume("a.vtk", changed(vtk_text(), "POINTS 8", "POINTS " + huge)), MeshError);
  EXPECT_THROW(read_volume("a.vtk", changed(vtk_5_text(), "CELLS 7 24", "CELLS 7 " + huge)),
               MeshError);
}

// Wherever a file is cut off, reading gives a mesh or a MeshError.
TEST(volume_mesh, every_cut_is_survived) {
  for (const auto& [name, whole] : cubes) {
    for (std::size_t length = 0; length < whole.size(); length += 7) {
      try {
        EXPECT_FALSE(read_volume(name, whole.substr(0, length)).elements.empty());
      } catch (const MeshError& error) {
        EXPECT_NE(error.remedy(), "");
      }
    }
  }
}

}  // namespace
}  // namespace pliant
