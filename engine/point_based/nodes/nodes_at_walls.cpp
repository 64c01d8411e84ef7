#include "engine/point_based/nodes/nodes_at_walls.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "engine/boundaries/overhang.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "kernels/layout.hpp"

namespace pliant::point_based {

namespace {

constexpr int points_to_a_side = 8;                          // along a side of a node's cell
constexpr double rounding_of_moves = 1e-9;                   // [pitch]
constexpr double farthest_before = 0.5 - rounding_of_moves;  // [pitch] of nodes that move
constexpr double farthest_behind = 0.75;                     // [pitch] so that none is missing
constexpr double farthest_beyond = 0.5;                      // [pitch] the rim of an overhang
constexpr double closest_on_walls = 0.25;                    // [pitch]

// The part of a node's cell outside no-slip walls, as a share of what the body fills of the cell.
template <int D>
double elastic_share(const Boundaries<D>& boundaries, const Shape& shape, const Point<D>& node,
                     const Point<D>& cell) {
  int inside = 0, elastic = 0;
  for (int k = 0; k < kernels::power(points_to_a_side, D); ++k) {
    Point<D> x = node;
    for (int a = 0, rest = k; a < D; ++a, rest /= points_to_a_side) {
      x[a] += cell[a] * ((rest % points_to_a_side + 0.5) / points_to_a_side - 0.5);
    }
    if (signed_distance(shape, padded<D>(x), D) > 0) continue;
    ++inside;
    if (boundaries.distance_to_no_slip(x) > 0) ++elastic;
  }
  return inside == 0 ? 1 : static_cast<double>(elastic) / inside;
}

template <int D>
double volume_of(const Point<D>& cell) {
  double volume = 1;
  for (const double side : cell) volume *= side;
  return volume;
}

/// A node that has moved by -`distance` along the normal of a wall, in units of the pitch in that
/// direction.
template <int D>
struct MovedNode {
  std::size_t node;
  Point<D> from;    ///< where it was [m]
  Point<D> beside;  ///< one pitch farther from the wall [m]
  double distance;
  double pitch;  ///< in that direction [m]
  bool slides;   ///< along the wall
};

// Where the body overhangs a wall, nodes a little beyond the rim move onto the rim.
template <int D>
void move_onto_walls(const Boundaries<D>& boundaries, const Shape& shape, const Point<D>& pitch,
                     std::size_t node, Point<D>& x, std::vector<MovedNode<D>>& moved) {
  for (const Wall<D>& wall : boundaries.walls) {
    if (!wall.is_attached()) continue;
    const double distance = wall.distance(x);
    const Point<D> n = wall.normal(x);
    double square = 0;
    for (int a = 0; a < D; ++a) square += n[a] * pitch[a] * n[a] * pitch[a];
    const double along = std::sqrt(square);
    if (distance > farthest_before * along || distance < -farthest_behind * along) continue;
    const auto rim = way_to_rim<D>(shape, wall, x, 0);
    if (rim && rim->is_beyond && rim->way.norm() > farthest_beyond * along) continue;
    const Point<D> from = x;
    Point<D> beside;
    for (int a = 0; a < D; ++a) {
      x[a] -= distance * n[a];
      beside[a] = x[a] + (along + distance) * n[a];
    }
    if (rim && rim->is_beyond) x = as_point<D>(column<D>(x) + rim->way);
    moved.push_back({node, from, beside, distance / along, along, wall.slips()});
  }
}

// Where two nodes have come to nearly the same place of a wall, as two on a side of the body before
// and behind the wall do, the one that was farther from the wall goes back.
template <int D>
void part(std::vector<MovedNode<D>>& moved, std::vector<Point<D>>& positions) {
  struct Way {
    double length;  // the longest [pitch]
    Point<D> from;
  };
  std::map<std::size_t, Way> ways;  // of each moved node
  for (const MovedNode<D>& one : moved) {
    Way& way = ways.try_emplace(one.node, Way{0, one.from}).first->second;
    way.length = std::max(way.length, std::abs(one.distance));
  }
  if (ways.size() < 2) return;
  std::vector<std::size_t> nodes;
  std::vector<Point<D>> places;
  for (const auto& [node, way] : ways) {
    nodes.push_back(node);
    places.push_back(positions[node]);
  }
  const NearestNodes<D> nearest(places);
  std::erase_if(moved, [&](const MovedNode<D>& one) {
    const std::size_t own = std::ranges::lower_bound(nodes, one.node) - nodes.begin();
    const auto found = nearest.nearest(places[own], 2);
    if (found[1].distance > closest_on_walls * one.pitch) return false;
    const auto first = static_cast<std::size_t>(found[0].node);
    const std::size_t other = nodes[first == own ? found[1].node : first];
    const Way &way = ways.at(one.node), &of_other = ways.at(other);
    if (std::pair(way.length, one.node) < std::pair(of_other.length, other)) return false;
    positions[one.node] = way.from;
    return true;
  });
}

// A moved node and the next one share the gap between them equally, as all other nodes do.
template <int D>
void share_gaps(const std::vector<MovedNode<D>>& moved, const NodeCloud<D>& cloud,
                std::vector<double>& elastic) {
  if (moved.empty()) return;
  const NearestNodes<D> nearest(cloud.positions);
  for (const MovedNode<D>& one : moved) {
    if (one.slides) continue;
    const std::int32_t next = nearest.nearest(one.beside);
    const double given = cloud.volumes[one.node] * one.distance / 2;
    if (elastic[next] <= -given || elastic[one.node] <= given) continue;
    elastic[one.node] -= given;
    elastic[next] += given;
  }
}

}  // namespace

template <int D>
std::vector<double> fit_to_walls(const Boundaries<D>& boundaries, const Shape& shape,
                                 const std::optional<Point<D>>& pitch, NodeCloud<D>& cloud) {
  std::vector<double> elastic = cloud.volumes;
  std::vector<MovedNode<D>> moved;
  for (std::size_t i = 0; i < elastic.size(); ++i) {
    Point<D>& x = cloud.positions[i];
    Point<D> cell;
    cell.fill(std::pow(cloud.volumes[i], 1. / D));
    if (pitch && cloud.volumes[i] < 2 * volume_of<D>(*pitch)) cell = *pitch;
    const double size = *std::max_element(cell.begin(), cell.end());
    if (boundaries.nearest_wall(x).second > size) continue;
    const double distance = boundaries.distance_to_no_slip(x);
    if (distance < size) {
      elastic[i] *= distance < -size ? 0 : elastic_share<D>(boundaries, shape, x, cell);
    }
    move_onto_walls<D>(boundaries, shape, cell, i, x, moved);
  }
  part<D>(moved, cloud.positions);
  for (const MovedNode<D>& one : moved) {
    if (std::abs(one.distance) > rounding_of_moves) cloud.is_regular = false;
  }
  share_gaps(moved, cloud, elastic);
  return elastic;
}

template <int D>
std::vector<double> volumes_of_free_elements(const Boundaries<D>& boundaries,
                                             const std::vector<double>& reach,
                                             const NodeCloud<D>& cloud) {
  std::vector<double> elastic(cloud.volumes.size(), 0);
  const auto is_held = [&](std::int32_t i) {
    return boundaries.distance_to_no_slip(cloud.positions[i]) < reach[i];
  };
  for (const std::array<std::int32_t, D + 1>& corners : cloud.elements) {
    if (std::ranges::all_of(corners, is_held)) continue;
    Eigen::Matrix<double, D, D> edges;
    for (int a = 0; a < D; ++a) {
      edges.col(a) =
          column<D>(cloud.positions[corners[a + 1]]) - column<D>(cloud.positions[corners[0]]);
    }
    const double share = std::abs(edges.determinant()) / ((D == 2 ? 2 : 6) * (D + 1));
    for (const std::int32_t corner : corners) elastic[corner] += share;
  }
  return elastic;
}

template std::vector<double> fit_to_walls<2>(const Boundaries<2>&, const Shape&,
                                             const std::optional<Point<2>>&, NodeCloud<2>&);
template std::vector<double> fit_to_walls<3>(const Boundaries<3>&, const Shape&,
                                             const std::optional<Point<3>>&, NodeCloud<3>&);

template std::vector<double> volumes_of_free_elements<2>(const Boundaries<2>&,
                                                         const std::vector<double>&,
                                                         const NodeCloud<2>&);
template std::vector<double> volumes_of_free_elements<3>(const Boundaries<3>&,
                                                         const std::vector<double>&,
                                                         const NodeCloud<3>&);

}  // namespace pliant::point_based
