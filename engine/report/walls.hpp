#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/case/case.hpp"

namespace pliant::report {

/// A wall as a picture shows it, where it is at t = 0.
struct WallPicture {
  std::string name;
  std::vector<Vector> vertex = {};           ///< [m]
  std::vector<std::uint32_t> triangle = {};  ///< three vertices each, anticlockwise from outside
  bool is_plane = false;                     ///< the face of a half-space
  std::vector<Vector> shift = {};  ///< [frame] displacement since t = 0 [m]; empty: it never moves
  Vector centre = {}, axis = {};   ///< about which it turns, at t = 0
  std::vector<double> angle = {};  ///< [frame] [rad]; empty: it never turns
};

/// The walls of a case inside a box, at the times of its frames. Half-spaces are their faces in 3D;
/// all other solids are whole, and closed where the box ends. Walls outside the box are left out.
std::vector<WallPicture> picture_walls(const Case& a_case, const Box<3>& box,
                                       const std::vector<double>& times);

}  // namespace pliant::report
