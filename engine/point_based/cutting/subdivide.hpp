#pragma once

#include <array>
#include <cmath>

#include "engine/lattice/lattice.hpp"

/// Pieces of surfaces, segments in 2D and triangles in 3D.
namespace pliant::point_based {

template <int D>
Point<D> between(const Point<D>& a, const Point<D>& b, double share) {
  Point<D> x;
  for (int i = 0; i < D; ++i) x[i] = a[i] + share * (b[i] - a[i]);
  return x;
}

template <int D>
Point<D> centre(const std::array<Point<D>, D>& piece) {
  Point<D> x = {};
  for (const Point<D>& corner : piece) {
    for (int a = 0; a < D; ++a) x[a] += corner[a] / D;
  }
  return x;
}

/// Calls f(piece) for parts of a piece with edges no longer than `length`.
template <int D, class F>
void subdivide(const std::array<Point<D>, D>& piece, double length, F&& f) {
  int from = 0;
  double longest = 0;
  for (int k = 0; k < D; ++k) {
    double square = 0;
    for (int a = 0; a < D; ++a) square += std::pow(piece[(k + 1) % D][a] - piece[k][a], 2);
    if (square <= longest) continue;
    longest = square;
    from = k;
  }
  if (longest <= length * length) return f(piece);
  const int to = (from + 1) % D;
  std::array<Point<D>, D> first = piece, second = piece;
  first[to] = second[from] = between<D>(piece[from], piece[to], 0.5);
  subdivide<D>(first, length, f);
  subdivide<D>(second, length, f);
}

}  // namespace pliant::point_based
