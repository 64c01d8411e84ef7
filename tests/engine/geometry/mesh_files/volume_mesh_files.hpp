#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/engine/geometry/mesh_files/mesh_files.hpp"

/// The unit cube of six tetrahedra (with one boundary triangle) in several file formats.
namespace pliant::tests {

inline constexpr int cube_elements[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                            {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

/// Coordinate `axis` of corner `v`, 0 or 1.
inline int cube_coordinate(int v, int axis) { return v >> axis & 1; }

template <class Value>
std::string big_endian(Value value) {
  std::string text = bytes(value);
  std::reverse(text.begin(), text.end());
  return text;
}

/// Number of a node in the files: 10, 20, ...
inline std::int64_t cube_tag(int v) { return 10 * (v + 1); }

inline std::string gmsh_2_text() {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n";
  for (int v = 0; v < 8; ++v) {
    text += fmt::format("{} {} {} {}\n", cube_tag(v), cube_coordinate(v, 0), cube_coordinate(v, 1),
                        cube_coordinate(v, 2));
  }
  text += "$EndNodes\n$Elements\n7\n1 2 2 0 1 10 20 40\n";
  for (int e = 0; e < 6; ++e) {
    text += fmt::format("{} 4 2 0 1", e + 2);
    for (const int v : cube_elements[e]) text += fmt::format(" {}", cube_tag(v));
    text += "\n";
  }
  return text + "$EndElements\n";
}

inline std::string gmsh_2_binary() {
  const auto i32 = [](std::int64_t i) { return bytes(static_cast<std::int32_t>(i)); };
  std::string text = "$MeshFormat\n2.2 1 8\n" + i32(1) + "\n$EndMeshFormat\n$Nodes\n8\n";
  for (int v = 0; v < 8; ++v) {
    text += i32(cube_tag(v));
    for (int a = 0; a < 3; ++a) text += bytes(static_cast<double>(cube_coordinate(v, a)));
  }
  text += "\n$EndNodes\n$Elements\n7\n" + i32(2) + i32(1) + i32(1);
  text += i32(1) + i32(5) + i32(10) + i32(20) + i32(40);
  text += i32(4) + i32(6) + i32(1);
  for (int e = 0; e < 6; ++e) {
    text += i32(e + 2) + i32(5);
    for (const int v : cube_elements[e]) text += i32(cube_tag(v));
  }
  return text + "\n$EndElements\n";
}

inline std::string gmsh_4_text() {
  std::string text =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 0\n$EndEntities\n"
      "$Nodes\n2 8 10 80\n2 1 1 3\n10\n20\n30\n0 0 0 0.5 0.5\n1 0 0 0 0\n0 1 0 0 0\n3 1 0 5\n";
  for (int v = 3; v < 8; ++v) text += fmt::format("{}\n", cube_tag(v));
  for (int v = 3; v < 8; ++v) {
    text += fmt::format("{} {} {}\n", cube_coordinate(v, 0), cube_coordinate(v, 1),
                        cube_coordinate(v, 2));
  }
  text += "$EndNodes\n$Elements\n2 7 1 7\n2 1 2 1\n1 10 20 40\n3 1 4 6\n";
  for (int e = 0; e < 6; ++e) {
    text += std::to_string(e + 2);
    for (const int v : cube_elements[e]) text += fmt::format(" {}", cube_tag(v));
    text += "\n";
  }
  return text + "$EndElements\n";
}

inline std::string gmsh_4_binary() {
  const auto i32 = [](std::int64_t i) { return bytes(static_cast<std::int32_t>(i)); };
  const auto i64 = [](std::int64_t i) { return bytes(i); };
  std::string text = "$MeshFormat\n4.1 1 8\n" + i32(1) + "\n$EndMeshFormat\n$Nodes\n";
  text += i64(1) + i64(8) + i64(10) + i64(80) + i32(3) + i32(1) + i32(0) + i64(8);
  for (int v = 0; v < 8; ++v) text += i64(cube_tag(v));
  for (int v = 0; v < 8; ++v) {
    for (int a = 0; a < 3; ++a) text += bytes(static_cast<double>(cube_coordinate(v, a)));
  }
  text += "\n$EndNodes\n$Elements\n" + i64(1) + i64(6) + i64(1) + i64(6);
  text += i32(3) + i32(1) + i32(4) + i64(6);
  for (int e = 0; e < 6; ++e) {
    text += i64(e + 1);
    for (const int v : cube_elements[e]) text += i64(cube_tag(v));
  }
  return text + "\n$EndElements\n";
}

inline std::string vtk_points(bool is_text) {
  std::string text;
  for (int v = 0; v < 8; ++v) {
    for (int a = 0; a < 3; ++a) {
      const int x = cube_coordinate(v, a);
      text += is_text ? std::to_string(x) + " " : big_endian(static_cast<float>(x));
    }
    if (is_text) text += "\n";
  }
  return text + "\n";
}

inline std::string vtk_text() {
  std::string text = "# vtk DataFile Version 3.0\na cube\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  text += "POINTS 8 float\n" + vtk_points(true) + "CELLS 7 34\n3 0 1 3\n";
  for (const auto& element : cube_elements) {
    text += fmt::format("4 {} {} {} {}\n", element[0], element[1], element[2], element[3]);
  }
  return text + "CELL_TYPES 7\n5\n10\n10\n10\n10\n10\n10\nCELL_DATA 7\n";
}

inline std::string vtk_binary() {
  const auto i32 = [](int i) { return big_endian(static_cast<std::int32_t>(i)); };
  std::string text = "# vtk DataFile Version 3.0\na cube\nBINARY\nDATASET UNSTRUCTURED_GRID\n";
  text += "POINTS 8 float\n" + vtk_points(false) + "CELLS 6 30\n";
  for (const auto& element : cube_elements) {
    text += i32(4);
    for (const int v : element) text += i32(v);
  }
  text += "\nCELL_TYPES 6\n";
  for (int e = 0; e < 6; ++e) text += i32(10);
  return text + "\n";
}

inline std::string vtk_5_text() {
  std::string text = "# vtk DataFile Version 5.1\na cube\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  text += "POINTS 8 float\n" + vtk_points(true) + "METADATA\nINFORMATION 0\n\n";
  text += "CELLS 7 24\nOFFSETS vtktypeint64\n0 4 8 12 16 20 24\nCONNECTIVITY vtktypeint64\n";
  for (const auto& element : cube_elements) {
    text += fmt::format("{} {} {} {}\n", element[0], element[1], element[2], element[3]);
  }
  return text + "CELL_TYPES 6\n10\n10\n10\n10\n10\n10\n";
}

}  // namespace pliant::tests
