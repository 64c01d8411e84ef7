#include "engine/point_based/walls_in_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/nodes/mesh_nodes.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"

namespace pliant::point_based {

namespace {

/// How a wall holds a mesh.
struct Hold {
  double depth = 0;   ///< mean depth in the wall of the nodes that it holds in the elements it cuts
  double extent = 0;  ///< how far the mesh reaches from the wall, or half the width of the wall
};

template <int D>
Hold hold_of(const Shape& wall, const NodeCloud<D>& mesh) {
  std::vector<double> distance;
  Hold hold;
  for (const Point<D>& x : mesh.positions) {
    distance.push_back(signed_distance(wall, padded<D>(x), D));
    hold.extent = std::max(hold.extent, distance.back());
  }
  const std::vector<double> reach = reach_of_walls<D>(mesh);
  const auto is_held = [&](std::int32_t i) { return distance[i] < reach[i]; };
  int count = 0;
  for (const std::array<std::int32_t, D + 1>& corners : mesh.elements) {
    if (std::ranges::all_of(corners, is_held)) continue;
    for (const std::int32_t corner : corners) {
      if (!is_held(corner)) continue;
      hold.depth -= distance[corner];
      ++count;
    }
  }
  if (count > 0) hold.depth /= count;
  const Box<3> box = bounding_box(wall);
  for (int a = 0; a < D; ++a) {
    hold.extent = std::min(hold.extent, (box.upper[a] - box.lower[a]) / 2);
  }
  return hold;
}

template <int D>
void warn_of_body(const Case& a_case, const BodyCase& body, std::vector<std::string>& warnings) {
  constexpr double unmentioned = 0.01;
  const Shape& shape = body.geometry;
  const NodeCloud<D> mesh =
      nodes_of_mesh<D>(read_volume_mesh(shape.file, D), shape.scale, shape.translate);
  for (const BoundaryCase& boundary : a_case.boundaries) {
    const auto& kind = row_of(boundary.kind);
    if (!kind.is_attached || boundary.kind == BoundaryCase::Kind::slip_wall) continue;
    const Hold hold = hold_of<D>(boundary.geometry, mesh);
    if (std::abs(hold.depth) <= unmentioned * hold.extent) continue;
    warnings.push_back(fmt::format(
        "the wall `{}` cuts through elements of body `{}` and holds it at nodes that lie {:.3g} m "
        "{} it: it is about {:.2g} % too {}, and up to five times as much where it bends, or "
        "overhangs or surrounds the wall; use a mesh with nodes on the wall",
        boundary.name, body.name, std::abs(hold.depth), hold.depth > 0 ? "inside" : "before",
        100 * std::abs(hold.depth) / hold.extent, hold.depth > 0 ? "soft" : "stiff"));
  }
}

}  // namespace

void warn_of_walls_in_meshes(const Case& a_case, std::vector<std::string>& warnings) {
  for (const BodyCase& body : a_case.bodies) {
    if (!has_elements(body.geometry)) continue;
    if (a_case.dimension == 2) {
      warn_of_body<2>(a_case, body, warnings);
    } else {
      warn_of_body<3>(a_case, body, warnings);
    }
  }
}

}  // namespace pliant::point_based
