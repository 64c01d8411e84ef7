#include "engine/remeshed/observe/surface_mesh.hpp"

#include <unordered_map>

#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

namespace {

// A line between two nodes of a cube: its lower end, and the axes along which the upper one lies.
template <int D>
struct Line {
  Cell<D> lower;
  int axes;
  bool operator==(const Line&) const = default;
};

template <int D>
Line<D> line_of(const Crossing<D>& crossing) {
  const Cell<D>&a = crossing.inside->cell, &b = crossing.outside->cell;
  Line<D> line{a, 0};
  for (int i = 0; i < D; ++i) {
    line.lower[i] = std::min(a[i], b[i]);
    line.axes |= (a[i] != b[i]) << i;
  }
  return line;
}

template <int D>
struct LineHash {
  std::size_t operator()(const Line<D>& line) const {
    auto hash = static_cast<std::uint64_t>(line.axes);
    for (const std::int32_t c : line.lower) {
      hash = (hash ^ static_cast<std::uint32_t>(c)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

template <int D>
SurfaceVertex<D> vertex_of(const Crossing<D>& crossing, const Place<D>& place) {
  SurfaceVertex<D> vertex{{}, crossing.inside->slot, crossing.outside->slot, crossing.fraction()};
  for (int a = 0; a < D; ++a) vertex.place[a] = place[a];
  return vertex;
}

}  // namespace

template <class T, int D>
ExtractedSurface<D> surface_mesh(const LatticeView<T, D>& view, const Boundaries<D>& boundaries) {
  ExtractedSurface<D> surface;
  std::unordered_map<Line<D>, std::int64_t, LineHash<D>> vertex_on;
  for_each_surface_piece(
      view, boundaries, [&](const SurfacePiece<D>& piece, const std::array<Place<D>, D>& places) {
        auto& corners = surface.pieces.emplace_back();
        for (int i = 0; i < D; ++i) {
          const auto next = static_cast<std::int64_t>(surface.vertices.size());
          const auto [entry, is_new] = vertex_on.try_emplace(line_of(piece[i]), next);
          if (is_new) surface.vertices.push_back(vertex_of(piece[i], places[i]));
          corners[i] = entry->second;
        }
      });
  return surface;
}

template ExtractedSurface<2> surface_mesh<double, 2>(const LatticeView<double, 2>&,
                                                     const Boundaries<2>&);
template ExtractedSurface<3> surface_mesh<double, 3>(const LatticeView<double, 3>&,
                                                     const Boundaries<3>&);
template ExtractedSurface<2> surface_mesh<float, 2>(const LatticeView<float, 2>&,
                                                    const Boundaries<2>&);
template ExtractedSurface<3> surface_mesh<float, 3>(const LatticeView<float, 3>&,
                                                    const Boundaries<3>&);

}  // namespace pliant::remeshed
