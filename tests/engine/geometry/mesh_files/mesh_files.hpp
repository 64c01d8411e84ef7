#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pliant::tests {

/// The bytes of a value in a binary file.
template <class Value>
std::string bytes(Value value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// A tetrahedron with corners at the origin and at 1 on each axis; volume 1/6.
inline constexpr int tetrahedron_corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr int tetrahedron[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

inline std::string binary_stl() {
  std::string text(80, '\0');
  text.replace(0, 5, "solid");  // some programs write this, against the rules
  text += bytes(std::uint32_t{4});
  for (const auto& triangle : tetrahedron) {
    text += std::string(12, '\0');
    for (const int v : triangle) {
      for (const int x : tetrahedron_corners[v]) text += bytes(static_cast<float>(x));
    }
    text += std::string(2, '\0');
  }
  return text;
}

inline std::string ascii_stl() {
  std::string text = "solid organ\n";
  for (const auto& triangle : tetrahedron) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const int v : triangle) {
      text += "      vertex";
      for (const int x : tetrahedron_corners[v]) text += " " + std::to_string(x) + ".0e+00";
      text += "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid organ\n";
}

/// The unit cube, of quadrilaterals.
inline const std::string obj_cube = R"(# a cube
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
vn 0 0 1
usemtl liver
f 4 3 2 1
f 5//1 6//1 7//1 8//1
f 1/1 2/2 6/3 5/4
f 2 3 7 6
f -6 -5 -1 -2
f 4 1 5 8
)";

inline const std::string ascii_ply = R"(ply
format ascii 1.0
comment a tetrahedron
element vertex 4
property float x
property float y
property float z
property uchar red
element face 4
property list uchar int vertex_indices
end_header
0 0 0 255
1 0 0 255
0 1 0 255
0 0 1 255
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
)";

inline std::string binary_ply() {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty uchar red\n"
      "property double x\nproperty double y\nproperty double z\nelement face 4\n"
      "property list uint8 uint32 vertex_index\nelement edge 1\nproperty short a\nend_header\n";
  for (const auto& corner : tetrahedron_corners) {
    text += bytes(std::uint8_t{255});
    for (const int x : corner) text += bytes(static_cast<double>(x));
  }
  for (const auto& triangle : tetrahedron) {
    text += bytes(std::uint8_t{3});
    for (const int v : triangle) text += bytes(static_cast<std::uint32_t>(v));
  }
  return text + bytes(std::int16_t{0});
}

}  // namespace pliant::tests
