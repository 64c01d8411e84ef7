#pragma once

#include <Eigen/LU>
#include <array>
#include <utility>
#include <vector>

#include "engine/lattice/surface_pieces.hpp"

/// The part of a simplex of lattice nodes in which phi < 0, divided into simplices.
///
/// It is a cone from its first inside node to two bases: the pieces of the surface in the simplex,
/// and the inside part of the facet opposite to that node, which is divided in the same way. The
/// division of a facet is therefore the same in both of its simplices. So the parts of all
/// simplices form a conforming mesh, whose boundary consists of the pieces of surface_pieces.hpp.
namespace pliant {

/// A corner of a part: a crossing, or a node, named twice.
template <int D>
using PartCorner = Crossing<D>;

namespace inside_parts {

template <int D>
using Corners = std::vector<PartCorner<D>>;
template <int D>
using Nodes = std::vector<const SurfaceNode<D>*>;

/// The pieces of the surface between inside and outside nodes, with arbitrary orientation.
template <int D>
std::vector<Corners<D>> pieces_between(const Nodes<D>& inside, const Nodes<D>& outside) {
  if (inside.size() == 2 && outside.size() == 2) {
    const PartCorner<D> first{inside[0], outside[0]}, third{inside[1], outside[1]};
    return {{first, {inside[0], outside[1]}, third}, {first, third, {inside[1], outside[0]}}};
  }
  Corners<D> piece;
  for (const auto* node : inside) {
    for (const auto* other : outside) piece.push_back({node, other});
  }
  return {piece};
}

/// Adds the parts; `apexes` precede the own corners of each.
template <int D>
void add_parts(const Nodes<D>& inside, const Nodes<D>& outside, Corners<D> apexes,
               std::vector<Corners<D>>& parts) {
  if (inside.empty()) return;
  apexes.push_back({inside.front(), inside.front()});
  if (outside.empty()) {
    for (std::size_t i = 1; i < inside.size(); ++i) apexes.push_back({inside[i], inside[i]});
    parts.push_back(apexes);
    return;
  }
  for (const Corners<D>& piece : pieces_between<D>(inside, outside)) {
    parts.push_back(apexes);
    parts.back().insert(parts.back().end(), piece.begin(), piece.end());
  }
  add_parts<D>({inside.begin() + 1, inside.end()}, outside, apexes, parts);
}

/// Whether a part is mirrored. Crossings are put halfway, where no part is flat.
template <int D>
bool is_mirrored(const std::array<PartCorner<D>, D + 1>& part) {
  const auto place = [](const PartCorner<D>& corner) -> PlaceVector<D> {
    return (corner.inside->place + corner.outside->place) / 2;
  };
  Eigen::Matrix<double, D, D> edges;
  for (int i = 0; i < D; ++i) edges.col(i) = place(part[i + 1]) - place(part[0]);
  return edges.determinant() < 0;
}

}  // namespace inside_parts

/// Calls f(part) for the parts of a simplex whose corners are in ascending order of their slots. A
/// part is std::array<PartCorner<D>, D + 1>, with a positive determinant of the edges from its
/// first corner.
template <int D, class F>
void for_each_inside_part(const std::array<const SurfaceNode<D>*, D + 1>& simplex, F&& f) {
  inside_parts::Nodes<D> inside, outside;
  for (const SurfaceNode<D>* node : simplex) (node->phi < 0 ? inside : outside).push_back(node);
  std::vector<inside_parts::Corners<D>> parts;
  inside_parts::add_parts<D>(inside, outside, {}, parts);
  for (const inside_parts::Corners<D>& corners : parts) {
    std::array<PartCorner<D>, D + 1> part;
    std::copy(corners.begin(), corners.end(), part.begin());
    if (inside_parts::is_mirrored<D>(part)) std::swap(part[D - 1], part[D]);
    f(part);
  }
}

}  // namespace pliant
