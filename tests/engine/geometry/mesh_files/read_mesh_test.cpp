#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "engine/geometry/closed_mesh.hpp"
#include "tests/engine/geometry/mesh_files/mesh_files.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant {
namespace {

using namespace tests;

SurfaceMesh read(const std::string& name, const std::string& content) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << content;
  return read_mesh(folder / name);
}

double volume(const std::string& name, const std::string& content) {
  return ClosedMesh(read(name, content), name).volume();
}

TEST(read_mesh, every_format_gives_the_same_tetrahedron) {
  EXPECT_DOUBLE_EQ(volume("a.stl", binary_stl()), 1. / 6);
  EXPECT_DOUBLE_EQ(volume("a.STL", ascii_stl()), 1. / 6);
  EXPECT_DOUBLE_EQ(volume("a.ply", ascii_ply), 1. / 6);
  EXPECT_DOUBLE_EQ(volume("a.ply", binary_ply()), 1. / 6);
}

TEST(read_mesh, polygons_become_fans_and_negative_corners_count_backwards) {
  EXPECT_EQ(read("a.obj", obj_cube).triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(volume("a.obj", obj_cube), 1);
}

TEST(read_mesh, lines_may_end_as_on_windows) {
  std::string text;
  for (const char c : obj_cube) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_DOUBLE_EQ(volume("a.obj", text), 1);
}

// Wherever a file is cut off, reading gives a mesh or a MeshError.
TEST(read_mesh, every_cut_is_survived) {
  const std::pair<const char*, std::string> files[] = {{"a.stl", binary_stl()},
                                                       {"a.stl", ascii_stl()},
                                                       {"a.obj", obj_cube},
                                                       {"a.ply", ascii_ply},
                                                       {"a.ply", binary_ply()}};
  for (const auto& [name, whole] : files) {
    for (std::size_t length = 0; length < whole.size(); length += 3) {
      try {
        const ClosedMesh mesh(read(name, whole.substr(0, length)), name);
        EXPECT_GT(mesh.volume(), 0);
      } catch (const MeshError& error) {
        EXPECT_NE(error.remedy(), "");
      }
    }
  }
}

// A header may announce any size: the reader must not allocate more than the file can fill.
TEST(read_mesh, wrong_numbers_of_elements_end_with_the_file) {
  for (const char* key : {"element vertex ", "element face "}) {
    for (const std::string& whole : {ascii_ply, binary_ply()}) {
      std::string content = whole;
      content.insert(content.find(key) + std::string(key).size(), "10000000000000000");
      EXPECT_THROW(read("a.ply", content), MeshError);
    }
  }
}

TEST(read_mesh, elements_that_are_not_read_may_be_empty) {
  std::string content = ascii_ply;
  content.insert(content.find("element face"), "element edge 0\n");
  EXPECT_EQ(read("a.ply", content).triangles.size(), 4u);
}

// Reading a pipe to its end would wait for the writer.
TEST(read_mesh, a_pipe_is_no_mesh) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "a.stl").c_str(), 0600), 0);
  EXPECT_THROW(read_mesh(folder / "a.stl"), MeshError);
}

}  // namespace
}  // namespace pliant
