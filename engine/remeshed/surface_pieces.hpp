#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "engine/remeshed/solver.hpp"

/// The free surface {phi = 0} of a body in front of every wall, in pieces: segments in 2D,
/// triangles in 3D.
///
/// Every cube of nodes is divided into D! simplices around its diagonal, in which phi is linear
/// (marching tetrahedra). Cubes that share a face divide it alike, so that pieces meet along whole
/// edges and the surface of a free body is closed, whatever phi is; no table of ambiguous cases is
/// needed, which marching cubes would.
namespace pliant::remeshed {

template <int D>
using Place = Eigen::Matrix<double, D, 1>;

/// A node of the lattice: a corner of cubes.
template <int D>
struct SurfaceNode {
  std::int64_t slot;
  Cell<D> cell;  ///< without the wrapping of periods
  Place<D> place;
  double phi;
};

/// Where the surface crosses the line between a node inside and one that is not.
template <int D>
struct Crossing {
  const SurfaceNode<D>* inside;
  const SurfaceNode<D>* outside;

  double fraction() const { return inside->phi / (inside->phi - outside->phi); }
  Place<D> place() const { return inside->place + fraction() * (outside->place - inside->place); }
};

/// Corners of a piece, in the order in which its normal points out of the body: anticlockwise from
/// outside in 3D, the body to the left in 2D.
template <int D>
using SurfacePiece = std::array<Crossing<D>, D>;

/// Calls f(piece) for the pieces in one simplex.
template <int D, class F>
void for_each_piece_of(std::array<const SurfaceNode<D>*, D + 1> simplex, F&& f) {
  const auto is_inside = [](const SurfaceNode<D>* node) { return node->phi < 0; };
  const auto middle = std::stable_partition(simplex.begin(), simplex.end(), is_inside);
  const auto inside = middle - simplex.begin();
  if (inside == 0 || inside == D + 1) return;
  Eigen::Matrix<double, D, D> edges;
  for (int i = 0; i < D; ++i) edges.col(i) = simplex[i + 1]->place - simplex[0]->place;
  bool mirrored = edges.determinant() < 0;
  const auto emit = [&](SurfacePiece<D> piece) {
    if (mirrored) std::swap(piece[0], piece[1]);
    f(piece);
  };
  if constexpr (D == 3) {
    if (inside == 2) {
      const Crossing<D> first{simplex[0], simplex[2]}, third{simplex[1], simplex[3]};
      emit({first, {simplex[0], simplex[3]}, third});
      emit({first, third, {simplex[1], simplex[2]}});
      return;
    }
  }
  SurfacePiece<D> piece;
  for (int i = 0; i < D; ++i) {
    piece[i] =
        inside == 1 ? Crossing<D>{simplex[0], simplex[i + 1]} : Crossing<D>{simplex[i], simplex[D]};
  }
  if (D == 2 && inside == D) mirrored = !mirrored;
  emit(piece);
}

/// The cubes of a body's nodes, one after another.
template <class T, int D>
class SurfaceCube {
 public:
  explicit SurfaceCube(const LatticeView<T, D>& view) : view_(view) {}

  /// Takes the cube between the node of `cell` and its neighbours; false where the surface does not
  /// cross it, or one of them is no particle.
  bool read(const Cell<D>& cell) {
    const T* phi = view_.fields.get(Field::level_set);
    int inside = 0;
    for (int c = 0; c < corners; ++c) {
      SurfaceNode<D>& node = corner_[c];
      node.cell = cell;
      for (int a = 0; a < D; ++a) node.cell[a] += c >> a & 1;
      node.slot = view_.population.layout.slot(view_.body.lattice.wrapped(node.cell));
      if (node.slot < 0 || view_.population.kind[node.slot] == Kind::vacant) return false;
      node.phi = phi[node.slot];
      inside += node.phi < 0 ? 1 : 0;
      for (int a = 0; a < D; ++a) node.place[a] = view_.body.lattice.node(a, node.cell[a]);
    }
    return inside > 0 && inside < corners;
  }

  /// Calls f(piece) for the pieces in the cube.
  template <class F>
  void for_each_piece(F&& f) const {
    std::array<int, D> axes;
    std::iota(axes.begin(), axes.end(), 0);
    do {
      std::array<const SurfaceNode<D>*, D + 1> simplex = {&corner_[0]};
      for (int i = 0, corner = 0; i < D; ++i) simplex[i + 1] = &corner_[corner |= 1 << axes[i]];
      for_each_piece_of<D>(simplex, f);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

 private:
  static constexpr int corners = 1 << D;
  const LatticeView<T, D>& view_;
  std::array<SurfaceNode<D>, corners> corner_;
};

/// Calls f(piece, corners' places) for every piece whose centre lies in front of all walls, in the
/// order of the slots; nodes last as long as the call.
template <class T, int D, class F>
void for_each_surface_piece(const LatticeView<T, D>& view, const Boundaries<D>& boundaries, F&& f) {
  SurfaceCube<T, D> cube(view);
  const Layout<D>& layout = view.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t, const Cell<D>& cell) {
      if (!view.body.lattice.is_wrapped(cell) || !cube.read(cell)) return;
      cube.for_each_piece([&](const SurfacePiece<D>& piece) {
        std::array<Place<D>, D> places;
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
