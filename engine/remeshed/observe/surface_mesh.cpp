#include "engine/remeshed/observe/surface_mesh.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

namespace {

// A line between two nodes of a cube: its lower end, and the axes along which the upper one is.
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
SurfaceVertex<D> vertex_of(const Crossing<D>& crossing) {
  SurfaceVertex<D> vertex{{}, crossing.inside->slot, crossing.outside->slot, crossing.fraction()};
  const PlaceVector<D> place = crossing.place();
  for (int a = 0; a < D; ++a) vertex.place[a] = place[a];
  return vertex;
}

/// Distance beyond the nearest end of the period [m], negative inside.
template <int D>
double beyond_period(const Lattice<D>& lattice, const Point<D>& x) {
  double beyond = -std::numeric_limits<double>::infinity();
  for (int a = 0; a < D; ++a) {
    if (lattice.period[a] == 0) continue;
    const double from_start = x[a] - lattice.origin[a];
    beyond = std::max({beyond, -from_start, from_start - lattice.period[a] * lattice.spacing});
  }
  return beyond;
}

/// Calls f for the cube that starts at a node and, at the start of the period, for cubes that
/// extend to it from beyond.
template <int D, class F>
void for_each_cube_of(const Lattice<D>& lattice, const Cell<D>& cell, F&& f) {
  Cell<D> first = cell;
  for (int a = 0; a < D; ++a) first[a] -= lattice.period[a] != 0 && cell[a] == 0 ? 1 : 0;
  for_each_cell<D>(first, cell, f);
}

}  // namespace

template <class T, int D>
ExtractedSurface<D> surface_mesh(const LatticeView<T, D>& view, const Boundaries<D>& boundaries) {
  ExtractedSurface<D> surface;
  std::unordered_map<Line<D>, std::int64_t, LineHash<D>> vertex_on;
  const auto add = [&](const SurfacePiece<D>& piece) {
    auto& corners = surface.pieces.emplace_back();
    for (int i = 0; i < D; ++i) {
      const auto next = static_cast<std::int64_t>(surface.vertices.size());
      const auto [entry, is_new] = vertex_on.try_emplace(line_of(piece[i]), next);
      if (is_new) surface.vertices.push_back(vertex_of(piece[i]));
      corners[i] = entry->second;
    }
  };
  const Lattice<D>& lattice = view.body.lattice;
  const Layout<D>& layout = view.population.layout;
  const T* phi = view.fields.get(Field::level_set);
  const auto level = [&](std::int64_t slot, const Point<D>& x) {
    const double depth =
        std::min(boundaries.nearest_wall(x).second, boundaries.nearest_contact(x).second);
    return std::max({static_cast<double>(phi[slot]), -depth, beyond_period<D>(lattice, x)});
  };
  SurfaceCube<T, D> cube(view);
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t, const Cell<D>& cell) {
      if (!lattice.is_wrapped(cell)) return;
      for_each_cube_of<D>(lattice, cell, [&](const Cell<D>& first) {
        if (cube.read(first, level)) cube.for_each_piece(add);
      });
    });
  }
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
