#include "engine/geometry/triangle_foot.hpp"

#include <Eigen/Dense>

namespace pliant {

TriangleFoot foot_on_triangle(const std::array<Eigen::Vector3d, 3>& c, const Eigen::Vector3d& x) {
  using Part = TriangleFoot::Part;
  const Eigen::Vector3d ab = c[1] - c[0], ac = c[2] - c[0];
  const double ab_a = ab.dot(x - c[0]), ac_a = ac.dot(x - c[0]);
  if (ab_a <= 0 && ac_a <= 0) return {Part::corner, 0, c[0], {1, 0, 0}};
  const double ab_b = ab.dot(x - c[1]), ac_b = ac.dot(x - c[1]);
  if (ab_b >= 0 && ac_b <= ab_b) return {Part::corner, 1, c[1], {0, 1, 0}};
  const double ab_c = ab.dot(x - c[2]), ac_c = ac.dot(x - c[2]);
  if (ac_c >= 0 && ab_c <= ac_c) return {Part::corner, 2, c[2], {0, 0, 1}};
  const double over_c = ab_a * ac_b - ab_b * ac_a;
  if (over_c <= 0 && ab_a >= 0 && ab_b <= 0) {
    const double t = ab_a / (ab_a - ab_b);
    return {Part::edge, 0, c[0] + t * ab, {1 - t, t, 0}};
  }
  const double over_b = ab_c * ac_a - ab_a * ac_c;
  if (over_b <= 0 && ac_a >= 0 && ac_c <= 0) {
    const double t = ac_a / (ac_a - ac_c);
    return {Part::edge, 2, c[0] + t * ac, {1 - t, 0, t}};
  }
  const double over_a = ab_b * ac_c - ab_c * ac_b;
  const double from_b = ac_b - ab_b, from_c = ab_c - ac_c;
  if (over_a <= 0 && from_b >= 0 && from_c >= 0) {
    const double t = from_b / (from_b + from_c);
    return {Part::edge, 1, c[1] + t * (c[2] - c[1]), {0, 1 - t, t}};
  }
  const double all = over_a + over_b + over_c;
  const double b = over_b / all, t = over_c / all;
  return {Part::face, 0, c[0] + b * ab + t * ac, {1 - b - t, b, t}};
}

}  // namespace pliant
