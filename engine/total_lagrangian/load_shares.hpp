#pragma once

#include <array>
#include <numbers>

#include "engine/lattice/surface_pieces.hpp"
#include "engine/method/decompositions.hpp"
#include "engine/undeformed/facet_places.hpp"

/// The shares of a cell's corners in the force on a facet inside it, (TL.27).
namespace pliant::total_lagrangian {

template <int D>
using Cube = std::array<SurfaceNode<D>, (1 << D)>;

using undeformed::Barycentric;

/// Corners of a facet in [0, 1]^D of its cell.
template <int D>
using PlacesInCell = std::array<Point<D>, D>;

/// One weight for each corner of a cell.
template <int D>
using Weights = std::array<double, (1 << D)>;

/// Calls f with the places and weights of a quadrature rule over a facet, exact for polynomials of
/// degree D: Gauss with two points in 2D, Dunavant with six in 3D.
template <int D, class F>
void for_each_gauss_point(F&& f) {
  if constexpr (D == 2) {
    const double u = 0.5 - std::numbers::sqrt3 / 6;
    f({1 - u, u}, 0.5);
    f({u, 1 - u}, 0.5);
  } else {
    constexpr std::array<double, 2> at = {0.445948490915965, 0.091576213509771};
    constexpr std::array<double, 2> weight = {0.223381589678011, 0.109951743655322};
    for (int i = 0; i < 2; ++i) {
      for (int v = 0; v < 3; ++v) {
        Barycentric<3> place = {at[i], at[i], at[i]};
        place[v] = 1 - 2 * at[i];
        f(place, weight[i]);
      }
    }
  }
}

/// Adds `factor` times the weights of multilinear interpolation at a place that is `off` [h] a
/// place on a facet.
template <int D>
void add_weights(const PlacesInCell<D>& places, const Barycentric<D>& at, const Point<D>& off,
                 double factor, Weights<D>& weights) {
  Point<D> s = off;
  for (int v = 0; v < D; ++v) {
    for (int a = 0; a < D; ++a) s[a] += at[v] * places[v][a];
  }
  for (int c = 0; c < (1 << D); ++c) {
    double weight = factor;
    for (int a = 0; a < D; ++a) weight *= c >> a & 1 ? s[a] : 1 - s[a];
    weights[c] += weight;
  }
}

/// Shares of the corners inside the body whose resultant acts at `middle` [m]. They have the
/// smallest norm, and so are linear in the places of the corners.
template <int D>
Weights<D> linear_shares(const Cube<D>& cube, const PlaceVector<D>& middle) {
  int count = 0;
  PlaceVector<D> mean = PlaceVector<D>::Zero();
  for (const SurfaceNode<D>& corner : cube) {
    if (corner.phi >= 0) continue;
    ++count;
    mean += corner.place;
  }
  mean /= count;
  Eigen::Matrix<double, D, D> spread = Eigen::Matrix<double, D, D>::Zero();
  for (const SurfaceNode<D>& corner : cube) {
    const PlaceVector<D> from_mean = corner.place - mean;
    if (corner.phi < 0) spread += from_mean * from_mean.transpose();
  }
  const PlaceVector<D> lever = pseudo_inverse<D>(spread) * (middle - mean);
  Weights<D> shares = {};
  for (int c = 0; c < (1 << D); ++c) {
    if (cube[c].phi < 0) shares[c] = 1. / count + (cube[c].place - mean).dot(lever);
  }
  return shares;
}

}  // namespace pliant::total_lagrangian
