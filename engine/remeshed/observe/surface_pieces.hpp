#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/lattice/surface_pieces.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

/// The surface of a body, in pieces.
namespace pliant::remeshed {

/// A cube between nodes of a body, and the pieces of the surface in it.
template <class T, int D>
class SurfaceCube {
 public:
  explicit SurfaceCube(const LatticeView<T, D>& view) : view_(view) {}

  /// Reads the cube from the node of `cell` on, with level(slot, place) [m] at its nodes. False if
  /// {level = 0} does not cross the cube, or if a node is not a particle.
  template <class Level>
  bool read(const Cell<D>& cell, Level&& level) {
    int inside = 0;
    for (int c = 0; c < corners; ++c) {
      SurfaceNode<D>& node = corner_[c];
      node.cell = cell;
      for (int a = 0; a < D; ++a) node.cell[a] += c >> a & 1;
      node.slot = view_.population.layout.slot(view_.body.lattice.wrapped(node.cell));
      if (node.slot < 0 || view_.population.kind[node.slot] == Kind::vacant) return false;
      const Point<D> place = view_.body.lattice.node(node.cell);
      for (int a = 0; a < D; ++a) node.place[a] = place[a];
      node.phi = level(node.slot, place);
      inside += node.phi < 0 ? 1 : 0;
    }
    return inside > 0 && inside < corners;
  }

  /// Calls f(piece) for the pieces in the cube.
  template <class F>
  void for_each_piece(F&& f) const {
    pliant::for_each_piece<D>(corner_, f);
  }

 private:
  static constexpr int corners = 1 << D;
  const LatticeView<T, D>& view_;
  std::array<SurfaceNode<D>, corners> corner_;
};

/// The level set of the body, as an argument of SurfaceCube::read.
template <class T, int D>
auto level_set_of(const LatticeView<T, D>& view) {
  return [values = view.fields.get(Field::level_set)](
             std::int64_t slot, const Point<D>&) -> double { return values[slot]; };
}

/// Calls f(piece, corners' places) for every piece of the free surface {phi = 0} whose centre is in
/// front of all walls, in the order of the slots. The nodes are valid only during the call.
template <class T, int D, class F>
void for_each_surface_piece(const LatticeView<T, D>& view, const Boundaries<D>& boundaries, F&& f) {
  SurfaceCube<T, D> cube(view);
  const Layout<D>& layout = view.population.layout;
  const auto phi = level_set_of<T, D>(view);
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t, const Cell<D>& cell) {
      if (!view.body.lattice.is_wrapped(cell) || !cube.read(cell, phi)) return;
      cube.for_each_piece([&](const SurfacePiece<D>& piece) {
        std::array<PlaceVector<D>, D> places;
        Point<D> centre = {};
        for (int i = 0; i < D; ++i) {
          places[i] = piece[i].place();
          for (int a = 0; a < D; ++a) centre[a] += places[i][a] / D;
        }
        if (boundaries.nearest_wall(centre).second > 0) f(piece, places);
      });
    });
  }
}

}  // namespace pliant::remeshed
