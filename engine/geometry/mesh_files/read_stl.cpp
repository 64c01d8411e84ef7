#include <fmt/format.h>

#include <cmath>

#include "engine/geometry/mesh_files/mesh_file.hpp"

// STL: triangles, each with its own vertices. Binary files have 80 arbitrary bytes, a count, and 50
// bytes for each triangle: a normal, three corners, two unused bytes.
namespace pliant {
namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

void add_triangle(SurfaceMesh& mesh, const std::array<Vector, 3>& corners) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

SurfaceMesh read_binary(const MeshFile& file) {
  if (file.content.size() < header_size) file.refuse_end(file.content.size(), "its header does");
  const auto count = value_at<std::uint32_t>(&file.content[80]);
  if (file.content.size() < header_size + triangle_size * count) {
    const std::size_t whole = (file.content.size() - header_size) / triangle_size;
    file.refuse_end(file.content.size(),
                    fmt::format("triangle {} of the {} that it announces", whole + 1, count));
  }
  SurfaceMesh mesh;
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<Vector, 3> corners;
    std::size_t at = header_size + triangle_size * t + 12;
    for (Vector& corner : corners) {
      for (double& component : corner) {
        component = value_at<float>(&file.content[at]);
        if (!std::isfinite(component)) {
          file.refuse_byte(at, fmt::format("a corner of triangle {} is not finite", t + 1),
                           "remove the triangle, or give it a place");
        }
        at += sizeof(float);
      }
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

SurfaceMesh read_text(const MeshFile& file) {
  SurfaceMesh mesh;
  MeshText text(file);
  std::array<Vector, 3> corners;
  std::size_t count = 0;
  bool ended = false;
  do {
    const std::string_view word = text.word_of_line();
    if (word == "vertex") {
      if (count == 3) text.refuse("a facet has more than three vertices", "triangulate the mesh");
      for (double& component : corners[count]) {
        component = text.number(text.word_of_line(), "a coordinate");
      }
      ++count;
    } else if (word == "endfacet") {
      if (count != 3) {
        text.refuse(fmt::format("a facet ends with {} vertices instead of three", count),
                    std::string(save_again));
      }
      add_triangle(mesh, corners);
      count = 0;
    }
    ended = word == "endsolid" || (ended && word.empty());
  } while (text.next_line());
  if (!ended) file.refuse_end(file.content.size(), "its `endsolid`");
  return mesh;
}

}  // namespace

SurfaceMesh read_stl(const MeshFile& file) {
  // Binary headers may begin with "solid" too, but text contains no zero bytes.
  const std::string_view start = std::string_view(file.content).substr(0, 512);
  const bool is_text = start.starts_with("solid") && start.find('\0') == start.npos;
  return is_text ? read_text(file) : read_binary(file);
}

}  // namespace pliant
