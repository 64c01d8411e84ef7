#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/case/case.hpp"

namespace pliant::report {

/// A wall in a picture, at its place at t = 0.
struct WallPicture {
  std::string name;
  std::vector<Vector> vertex = {};  ///< [m]
  std::vector<std::uint32_t> triangle =
      {};                 ///< three vertices each, ordered anticlockwise as seen from outside
  bool is_plane = false;  ///< the face of a half-space
  std::vector<Vector> shift = {};  ///< [frame] displacement since t = 0 [m]; empty: does not move
  Vector centre = {}, axis = {};   ///< of its rotation, at t = 0
  std::vector<double> angle = {};  ///< [frame] [rad]; empty: does not rotate
};

/// The walls of a case inside a box, at the times of its frames. In 3D, half-spaces are shown as
/// faces; other solids are closed at the end of the box.
std::vector<WallPicture> picture_walls(const Case& a_case, const Box<3>& box,
                                       const std::vector<double>& times);

}  // namespace pliant::report
