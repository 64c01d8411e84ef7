#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::remeshed {

/// Sum over the nodes of a lattice, near one at `depth` [h], of the weights max(0, 1 - abs(s - 1))
/// of their depths s behind a plane, per area of the plane [h^(1-D)]: (RP.110). It is 1 for planes
/// along axes, and 0.91 to 1.09 at 45 degrees.
template <int D>
double density_of_layer(const Point<D>& normal, double depth) {
  constexpr double pi = std::numbers::pi;
  constexpr double mean_over = 2;  // [h] along the wall, standard deviation
  constexpr double least = 1e-6;   // of a wave
  constexpr int highest = D == 2 ? 4 : 2;
  const auto is_whole = [](double component) { return component == std::round(component); };
  if (std::ranges::all_of(normal, is_whole)) return 1;
  const double most_across = -std::log(least) / (2 * pi * pi * mean_over * mean_over);
  double density = 1;
  Cell<D> first, last;
  first.fill(-highest);
  last.fill(highest);
  for_each_cell<D>(first, last, [&](const Cell<D>& wave) {
    double along = 0, square = 0;
    for (int a = 0; a < D; ++a) {
      along += wave[a] * normal[a];
      square += wave[a] * wave[a];
    }
    if (square == 0) return;
    const double across = std::max(square - along * along, 0.);
    if (across > most_across) return;
    const double mean = std::exp(-2 * pi * pi * mean_over * mean_over * across);
    const double sinc = std::sin(pi * along) / (pi * along);
    density += sinc * sinc * mean * std::cos(2 * pi * along * (depth - 1));
  });
  return density;
}

/// Weight of a ghost at `depth` [h] behind a wall in sums over the wall, (RP.65).
template <int D>
double weight_in_layer(const Point<D>& normal, double depth) {
  const double weight = std::max(0., 1 - std::abs(depth - 1));
  return weight > 0 ? weight / density_of_layer<D>(normal, depth) : 0;
}

}  // namespace pliant::remeshed
