#include <filesystem>
#include <fstream>
#include <limits>

#include "engine/case/writing/resolved.hpp"
#include "engine/geometry/closed_mesh.hpp"
#include "tests/engine/geometry/mesh_files/mesh_files.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/faults/fault.hpp"

namespace pliant::tests {
namespace {

struct MeshFault {
  const char* name;
  const char* file;
  std::string content;
  const char* message;  ///< what follows the place and "geometry has a faulty mesh: "

  friend std::ostream& operator<<(std::ostream& stream, const MeshFault& fault) {
    return stream << fault.name;
  }
};

constexpr const char* organ_case = R"(dimension = 3
discretisation = { spacing = 0.1 }
time = { end = 1 }
[[body]]
name = "organ"
geometry = { shape = "mesh", file = "FILE" }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
)";

/// The reader's error message for a case with this mesh, without the folder.
std::string mesh_complaint(const std::string& file, const std::string& content) {
  const test::TemporaryFolder folder;
  if (!content.empty()) std::ofstream(folder / file, std::ios::binary) << content;
  std::ofstream(folder / "organ.toml") << with(organ_case, "FILE", file);
  try {
    read_case(folder / "organ.toml");
    return "";
  } catch (const CaseError& error) {
    std::string message = error.what();
    const std::string path = (folder / "").string();
    for (std::size_t at = message.find(path); at != message.npos; at = message.find(path)) {
      message.erase(at, path.size());
    }
    return message;
  }
}

std::string cut(const std::string& content, std::size_t bytes_left) {
  return content.substr(0, bytes_left);
}

std::string with_bytes(std::string content, std::size_t at, const std::string& replacement) {
  return content.replace(at, replacement.size(), replacement);
}

const MeshFault faults[] = {
    {"no_file", "no.stl", "",
     "no.stl: cannot be read; give the path of the mesh from the folder "
     "of the case file"},
    {"an_unknown_ending", "organ.gts", "x",
     "organ.gts: no format is known by the ending \".gts\"; give a surface that ends in .stl, .obj "
     "or .ply, or tetrahedra that end in .msh or .vtk"},
    {"a_truncated_binary_stl", "organ.stl", cut(binary_stl(), 200),
     "organ.stl: byte 200: the file ends before triangle 3 of the 4 that it announces; save it "
     "again from the program that made it"},
    {"a_binary_stl_with_a_vertex_nowhere", "organ.stl",
     with_bytes(binary_stl(), 84 + 50 + 12, bytes(std::numeric_limits<float>::quiet_NaN())),
     "organ.stl: byte 146: a corner of triangle 2 is not finite; remove the triangle, or give it a "
     "place"},
    {"a_truncated_ascii_stl", "organ.stl", with(ascii_stl(), "endsolid organ\n", ""),
     "organ.stl: byte 692: the file ends before its `endsolid`; save it again from the program "
     "that made it"},
    {"an_ascii_stl_without_triangles", "organ.stl", "solid organ\nendsolid organ\n",
     "organ.stl: holds no triangle; export the surface with its faces"},
    {"an_ascii_stl_with_half_a_number", "organ.stl", with(ascii_stl(), "1.0e+00", "1.0e+"),
     "organ.stl:5: a coordinate must be a number, found \"1.0e+\"; save it again from the program "
     "that made it"},
    {"an_ascii_stl_with_a_vertex_nowhere", "organ.stl", with(ascii_stl(), "1.0e+00", "inf"),
     "organ.stl:5: a coordinate is not finite, found \"inf\"; remove the vertex, or give it a "
     "place"},
    {"a_facet_of_two_vertices", "organ.stl",
     with(ascii_stl(), "      vertex 0.0e+00 0.0e+00 0.0e+00\n", ""),
     "organ.stl:7: a facet ends with 2 vertices instead of three; save it again from the program "
     "that made it"},
    {"an_obj_with_an_index_out_of_range", "organ.obj", with(obj_cube, "f 2 3 7 6", "f 2 3 7 9"),
     "organ.obj:15: a face has the vertex 9, of 8 so far; count vertices from 1, or from -1 "
     "backwards, and put them before their faces"},
    {"an_obj_with_a_face_of_two_vertices", "organ.obj", with(obj_cube, "f 2 3 7 6", "f 2 3"),
     "organ.obj:15: a face has 2 vertices; give it three or more, or remove it"},
    {"an_open_obj", "organ.obj", with(obj_cube, "f 2 3 7 6\n", ""),
     "organ.obj: open edges: 4, the first near (1, 0, 0.5); close the surface, and give points "
     "that touch the same place"},
    {"a_ply_of_another_order", "organ.ply", with(ascii_ply, "ascii", "binary_big_endian"),
     "organ.ply:2: the format \"binary_big_endian\" is not read; save it as ascii or "
     "binary_little_endian"},
    {"an_ascii_ply_with_an_index_out_of_range", "organ.ply", with(ascii_ply, "3 0 2 1", "3 0 2 4"),
     "organ.ply:16: face 0 has the vertex 4, of 4; count vertices from 0, and put them before the "
     "faces"},
    {"a_truncated_ascii_ply", "organ.ply", with(ascii_ply, "3 1 2 3\n", ""),
     "organ.ply: byte 259: the file ends before face 3 of the 4 that it announces; save it again "
     "from the program that made it"},
    {"a_truncated_binary_ply", "organ.ply", cut(binary_ply(), 250),
     "organ.ply: byte 250: the file ends before vertex 1 of the 4 that it announces; save it again "
     "from the program that made it"},
    {"a_ply_with_vertices_without_properties", "organ.ply",
     "ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nend_header\n",
     "organ.ply:3: the element \"vertex\" has no properties; declare its properties, or remove the "
     "element"},
    {"a_ply_with_any_element_without_properties", "organ.ply",
     with(ascii_ply, "element face", "element edge 9000000000000000000\nelement face"),
     "organ.ply:9: the element \"edge\" has no properties; declare its properties, or remove the "
     "element"},
    {"a_ply_with_vertices_without_z", "organ.ply", with(ascii_ply, "float z", "float depth"),
     "organ.ply:4: the element \"vertex\" has no property z; export vertices with x, y and z"},
    {"a_ply_with_vertices_whose_z_is_a_list", "organ.ply",
     with(ascii_ply, "float z", "list uchar float z"),
     "organ.ply:4: the element \"vertex\" has no property z; export vertices with x, y and z"},
    {"a_ply_with_faces_without_vertices", "organ.ply",
     with(ascii_ply, "vertex_indices", "neighbours"),
     "organ.ply:9: the element \"face\" has no list of vertices; export faces with the list "
     "vertex_indices"},
    {"a_ply_without_format", "organ.ply", with(ascii_ply, "format ascii 1.0\n", ""),
     "organ.ply:1: the header has no line `format`; save it again from the program that made it"},
    {"an_ascii_ply_with_more_vertices_than_the_file_holds", "organ.ply",
     with(ascii_ply, "vertex 4", "vertex 9000000000000000000"),
     "organ.ply: byte 285: the file ends before vertex 8 of the 9000000000000000000 that it "
     "announces; save it again from the program that made it"},
    {"a_binary_ply_with_more_vertices_than_the_file_holds", "organ.ply",
     with(binary_ply(), "vertex 4", "vertex 9000000000000000000"),
     "organ.ply: byte 396: the file ends before vertex 6 of the 9000000000000000000 that it "
     "announces; save it again from the program that made it"},
    {"an_ascii_ply_with_an_endless_list", "organ.ply", with(ascii_ply, "3 0 2 1", "1e300 0 2 1"),
     "organ.ply: byte 271: the file ends before face 0 of the 4 that it announces; save it again "
     "from the program that made it"},
    {"an_ascii_ply_with_half_a_corner", "organ.ply", with(ascii_ply, "3 0 2 1", "3 0 2 1.5"),
     "organ.ply:16: face 0 has the vertex 1.5, of 4; count vertices from 0, and put them before "
     "the faces"},
    {"an_ascii_ply_with_half_a_list", "organ.ply", with(ascii_ply, "3 0 2 1", "2.5 0 2 1"),
     "organ.ply:16: face 0 has a list of 2.5 values; save it again from the program that made it"},
    {"a_ply_header_without_end", "organ.ply", cut(ascii_ply, 60),
     "organ.ply: byte 60: the file ends before its `end_header`; save it again from the program "
     "that made it"},
};

class FaultyMesh : public testing::TestWithParam<MeshFault> {};

TEST_P(FaultyMesh, is_answered_with_where_what_and_what_to_do) {
  EXPECT_EQ(mesh_complaint(GetParam().file, GetParam().content),
            std::string("organ.toml:6: geometry has a faulty mesh: ") + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(faults, FaultyMesh, testing::ValuesIn(faults),
                         [](const auto& fault) { return fault.param.name; });

TEST(meshes, are_placed_and_scaled_and_found_from_the_folder_of_the_case) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "meshes");
  std::ofstream(folder / "meshes" / "organ.obj") << obj_cube;
  std::ofstream(folder / "organ.toml")
      << with(organ_case, R"("FILE")", R"("meshes/organ.obj", scale = 2, translate = [0, 1, 0])");
  const Case read = read_case(folder / "organ.toml");
  const Shape& shape = read.bodies[0].geometry;
  EXPECT_EQ(shape.file, (folder / "meshes" / "organ.obj").string());
  EXPECT_DOUBLE_EQ(shape.mesh->volume(), 8);
  EXPECT_EQ(shape.mesh->bounds().upper, (Vector{2, 3, 2}));
}

TEST(meshes, a_resolved_case_finds_them_from_any_folder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "elsewhere");
  std::ofstream(folder / "organ.obj") << obj_cube;
  std::ofstream(folder / "organ.toml") << with(organ_case, "FILE", "organ.obj");
  const std::string resolved = resolved_toml(read_case(folder / "organ.toml"));
  std::ofstream(folder / "elsewhere" / "case.resolved.toml") << resolved;
  EXPECT_EQ(resolved_toml(read_case(folder / "elsewhere" / "case.resolved.toml")), resolved);
}

TEST(meshes, need_three_dimensions) {
  EXPECT_EQ(complaint(broken(geometry, R"({ shape = "mesh", file = "organ.stl" })")),
            "block.toml:8: shape is a mesh, which needs dimension = 3; set dimension = 3, or use "
            "other shapes");
}

}  // namespace
}  // namespace pliant::tests
