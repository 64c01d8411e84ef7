#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace pliant {

/// Vectors always have three components; in 2D the last is zero.
using Vector = std::array<double, 3>;

class ClosedMesh;

/// A solid in 2D or 3D, in SI units.
struct Shape {
  enum class Kind { box, ball, capsule, cylinder, half_space, mesh, unite, subtract, intersect };
  Kind kind = Kind::box;
  Vector lower = {}, upper = {};   ///< box; may be infinite
  Vector centre = {};              ///< ball (a disc in 2D), cylinder
  Vector from = {}, to = {};       ///< capsule: the ends of its axis
  double radius = 0;               ///< ball, capsule, cylinder
  Vector axis = {0, 0, 1};         ///< cylinder, infinite along it
  Vector point = {}, normal = {};  ///< half_space: the side opposite to the unit vector `normal`
  std::string file;                ///< mesh; full path
  double scale = 1;                ///< mesh; [m] per unit of the file
  Vector translate = {};           ///< mesh; position of the origin of the file [m]
  std::shared_ptr<const ClosedMesh> mesh;  ///< mesh; null until `load_meshes`
  std::vector<Shape> operands;  ///< unite, intersect; subtract: the first one without the others
};

}  // namespace pliant
