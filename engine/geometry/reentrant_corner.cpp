#include "engine/geometry/reentrant_corner.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant {

namespace {

constexpr double alike = 0.9;      // cosine between normals of a smooth surface in adjacent cells
constexpr double different = 0.7;  // cosine between the normals of two faces
constexpr double least_height = 0.4;  // of one face's foot over the other face, over the spacing
constexpr double on_surface = 0.01;   // of feet, over the spacing
constexpr double most_nodes = 40000;  // that a search of a whole surface visits

/// Height of the foot of `b` over the face of `a`.
double height_over(const Facet& a, const Facet& b) {
  return dot<3>(b.foot, a.normal) - dot<3>(a.foot, a.normal);
}

bool face_each_other(const Facet& a, const Facet& b) {
  return height_over(a, b) > least_height && height_over(b, a) > least_height;
}

/// The surface as seen from a node; none if the node is inside, or too far away. Distances outside
/// an edge of an intersection are those from the planes of its faces, whose feet are not on it.
std::optional<Facet> facet_seen(const Shape& surface, const Vector& node, const Vector& away,
                                int dimension, double spacing) {
  Vector x;
  for (int a = 0; a < 3; ++a) x[a] = node[a] + spacing * away[a];
  const double distance = signed_distance(surface, x, dimension) / spacing;
  if (distance < 0 || distance > farthest_node) return std::nullopt;
  Facet facet{away, outward_direction(surface, x, dimension)};
  for (int a = 0; a < dimension; ++a) {
    facet.foot[a] -= distance * facet.normal[a];
    x[a] -= spacing * distance * facet.normal[a];
  }
  const double missed = std::abs(signed_distance(surface, x, dimension));
  return missed < on_surface * spacing ? std::optional(facet) : std::nullopt;
}

template <int D>
bool is_corner_beside(const Shape& surface, const Vector& node, double spacing) {
  const std::optional<Facet> own = facet_seen(surface, node, {}, D, spacing);
  if (!own) return false;
  Cell<D> first, last;
  first.fill(-1);
  last.fill(1);
  std::vector<Facet> facets = {*own};
  for_each_cell<D>(first, last, [&](const Cell<D>& cell) {
    Vector away = {};
    for (int a = 0; a < D; ++a) away[a] = cell[a];
    if (const auto facet = facet_seen(surface, node, away, D, spacing)) facets.push_back(*facet);
  });
  return faces_of_corner(facets).has_value();
}

template <int D>
bool has_corner(const Shape& surface, const Box<3>& box, double spacing) {
  double volume = 1;
  for (int a = 0; a < D; ++a) volume *= box.upper[a] - box.lower[a];
  if (!std::isfinite(volume)) return false;
  const double step = std::max(spacing, std::pow(volume / most_nodes, 1. / D));
  Cell<D> first = {}, last;
  for (int a = 0; a < D; ++a) last[a] = cell_below((box.upper[a] - box.lower[a]) / step);
  bool found = false;
  for_each_cell<D>(first, last, [&](const Cell<D>& cell) {
    Vector node = {};
    for (int a = 0; a < D; ++a) node[a] = box.lower[a] + (cell[a] + 0.5) * step;
    found = found || is_corner_beside<D>(surface, node, step);
  });
  return found;
}

}  // namespace

bool are_alike(const Facet& a, const Facet& b) { return dot<3>(a.normal, b.normal) > alike; }

std::optional<std::array<Facet, 2>> faces_of_corner(std::span<const Facet> facets) {
  std::optional<std::array<Facet, 2>> faces;
  const auto continues = [&](const Facet& facet) { return are_alike(facet, facets.front()); };
  if (std::ranges::all_of(facets, continues)) return faces;
  double least = different;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double cosine = dot<3>(facets[i].normal, facets[j].normal);
      if (cosine >= least || cosine < -different) continue;
      if (!face_each_other(facets[i], facets[j])) continue;
      least = cosine;
      faces = {facets[j], facets[i]};
    }
  }
  return faces;
}

Vector meeting_place(const std::array<Facet, 2>& faces) {
  const auto& [first, second] = faces;
  const double cosine = dot<3>(first.normal, second.normal), sine_squared = 1 - cosine * cosine;
  const double one = dot<3>(first.foot, first.normal), two = dot<3>(second.foot, second.normal);
  Vector place;
  for (int a = 0; a < 3; ++a) {
    place[a] = ((one - cosine * two) * first.normal[a] + (two - cosine * one) * second.normal[a]) /
               sine_squared;
  }
  return place;
}

bool has_reentrant_corner(const Shape& surface, const Shape& box, int dimension, double spacing) {
  const Box<3> bounds = bounding_box(box);
  return dimension == 2 ? has_corner<2>(surface, bounds, spacing)
                        : has_corner<3>(surface, bounds, spacing);
}

}  // namespace pliant
