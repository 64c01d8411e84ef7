#include <fmt/format.h>

#include "engine/geometry/mesh_files/mesh_file.hpp"

// OBJ: lines `v x y z` and `f a b c ...`. A corner is v, v/t, v//n or v/t/n; it counts from 1, or
// from -1 for the last vertex so far. All other lines concern appearance and are skipped.
namespace pliant {
namespace {

std::int32_t corner(const MeshText& text, std::string_view word, std::size_t vertices) {
  const std::int64_t given = text.integer(word.substr(0, word.find('/')), "a corner of a face");
  const auto count = static_cast<std::int64_t>(vertices);
  const std::int64_t index = given < 0 ? count + given : given - 1;
  if (given == 0 || index < 0 || index >= count) {
    text.refuse(fmt::format("a face has the vertex {}, of {} so far", given, count),
                "count vertices from 1, or from -1 backwards, and put them before their faces");
  }
  return static_cast<std::int32_t>(index);
}

}  // namespace

SurfaceMesh read_obj(const MeshFile& file) {
  SurfaceMesh mesh;
  MeshText text(file);
  std::vector<std::int32_t> corners;
  do {
    const std::string_view key = text.word_of_line();
    if (key == "v") {
      Vector& vertex = mesh.vertices.emplace_back();
      for (double& component : vertex) {
        component = text.number(text.word_of_line(), "a coordinate");
      }
    } else if (key == "f") {
      corners.clear();
      for (std::string_view word = text.word_of_line(); !word.empty(); word = text.word_of_line()) {
        corners.push_back(corner(text, word, mesh.vertices.size()));
      }
      if (corners.size() < 3) {
        text.refuse(fmt::format("a face has {} vertices", corners.size()),
                    "give it three or more, or remove it");
      }
      add_fan(mesh, corners);
    }
  } while (text.next_line());
  return mesh;
}

}  // namespace pliant
