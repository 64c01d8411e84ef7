#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "engine/lattice/lattice.hpp"

/// The surface {phi = 0} between the nodes of a lattice, in pieces: segments in 2D, triangles in
/// 3D.
///
/// Every cube of nodes is divided into D! simplices around its diagonal, in which phi is linear
/// (marching tetrahedra). Cubes that share a face divide it in the same way. So pieces meet along
/// whole edges, and the surface of a free body is closed for any phi. Unlike marching cubes, this
/// needs no table of ambiguous cases.
namespace pliant {

template <int D>
using PlaceVector = Eigen::Matrix<double, D, 1>;

/// A node of a lattice: a corner of cubes.
template <int D>
struct SurfaceNode {
  std::int64_t slot;
  Cell<D> cell;  ///< without wrapping of periods
  PlaceVector<D> place;
  double phi;
};

/// Where the surface crosses the line between an inside node and one that is not inside.
template <int D>
struct Crossing {
  const SurfaceNode<D>* inside;
  const SurfaceNode<D>* outside;

  double fraction() const { return inside->phi / (inside->phi - outside->phi); }
  PlaceVector<D> place() const {
    return inside->place + fraction() * (outside->place - inside->place);
  }
};

/// Corners of a piece, in the order that makes its normal point out of the body: anticlockwise from
/// outside in 3D, the body to the left in 2D.
template <int D>
using SurfacePiece = std::array<Crossing<D>, D>;

/// Calls f(piece) for the pieces in one simplex.
template <int D, class F>
void for_each_piece_of(const std::array<const SurfaceNode<D>*, D + 1>& corners, F&& f) {
  // Inside nodes first; std::stable_partition would allocate.
  std::array<const SurfaceNode<D>*, D + 1> simplex;
  int inside = 0, outside = D + 1;
  for (int i = 0; i <= D; ++i) {
    if (corners[i]->phi < 0) simplex[inside++] = corners[i];
    if (!(corners[D - i]->phi < 0)) simplex[--outside] = corners[D - i];
  }
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

/// Calls f(simplex) for the D! simplices of the cube with these corners. The corners of each are in
/// ascending order of their slots.
template <int D, class F>
void for_each_simplex(const std::array<SurfaceNode<D>, (1 << D)>& cube, F&& f) {
  std::array<int, D> axes;
  std::iota(axes.begin(), axes.end(), 0);
  do {
    std::array<const SurfaceNode<D>*, D + 1> simplex = {&cube[0]};
    for (int i = 0, corner = 0; i < D; ++i) simplex[i + 1] = &cube[corner |= 1 << axes[i]];
    f(simplex);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

/// Calls f(piece) for the pieces in the cube with these corners.
template <int D, class F>
void for_each_piece(const std::array<SurfaceNode<D>, (1 << D)>& cube, F&& f) {
  for_each_simplex<D>(cube, [&f](const std::array<const SurfaceNode<D>*, D + 1>& simplex) {
    for_each_piece_of<D>(simplex, f);
  });
}

}  // namespace pliant
