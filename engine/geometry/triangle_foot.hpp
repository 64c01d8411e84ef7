#pragma once

#include <Eigen/Core>
#include <array>

namespace pliant {

/// A point of a triangle: inside, on the edge that starts at a corner, or at a corner.
struct TriangleFoot {
  enum class Part { face, edge, corner };
  Part part = Part::face;
  int corner = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::array<double, 3> weight = {};  ///< of the corners; their sum is 1
};

/// The point of a triangle nearest to `x`, by the regions that it may be in.
///
/// C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
TriangleFoot foot_on_triangle(const std::array<Eigen::Vector3d, 3>& c, const Eigen::Vector3d& x);

}  // namespace pliant
