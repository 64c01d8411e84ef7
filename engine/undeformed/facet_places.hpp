#pragma once

#include <array>
#include <span>
#include <vector>

/// Places spread over a facet, for loads and walls that end within it.
namespace pliant::undeformed {

template <int D>
using Barycentric = std::array<double, D>;

template <int D>
using FacetPlaces = std::vector<Barycentric<D>>;

/// The middles of equal parts of a facet.
template <int D>
FacetPlaces<D> middles_of_parts(int to_a_side) {
  FacetPlaces<D> places;
  for (int i = 0; i < to_a_side; ++i) {
    if constexpr (D == 2) {
      const double u = (i + 0.5) / to_a_side;
      places.push_back({1 - u, u});
    } else {
      const auto add = [&](double u, double v) { places.push_back({1 - u - v, u, v}); };
      for (int j = 0; i + j < to_a_side; ++j) {
        add((i + 1. / 3) / to_a_side, (j + 1. / 3) / to_a_side);
        if (i + j < to_a_side - 1) add((i + 2. / 3) / to_a_side, (j + 2. / 3) / to_a_side);
      }
    }
  }
  return places;
}

/// Places of which few lie on one line along a side: a Fibonacci lattice that is folded into the
/// triangle and turned by its corners, so that the mean is the centre. A straight line across the
/// facet leaves the right share of them on either side within 0.035; of the middles of 64 parts,
/// within 0.08.
inline FacetPlaces<3> dense_places_in_triangle() {
  constexpr int count = 89, step = 55;
  FacetPlaces<3> places;
  for (int i = 0; i < count; ++i) {
    double u = (i + 0.5) / count, v = (i * step % count + 0.5) / count;
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const double rest = 1 - u - v;
    places.push_back({rest, u, v});
    places.push_back({v, rest, u});
    places.push_back({u, v, rest});
  }
  return places;
}

template <int D>
FacetPlaces<D> dense_places() {
  if constexpr (D == 2) return middles_of_parts<2>(64);
  if constexpr (D == 3) return dense_places_in_triangle();
}

/// A sum over places spread over a facet. `sum(places)` returns it, with the number `count` of the
/// places and that of those where a load acts, `hit`. Where the rim of a load crosses the facet,
/// there are more places. A rim within h/16 of a side of the facet is taken for this side: regions
/// that are meant for one face often reach a little way over its edges.
template <int D, class Sum>
auto sum_over_facet(Sum&& sum) {
  static const FacetPlaces<D> middles = middles_of_parts<D>(8), dense = dense_places<D>();
  const auto simple = sum(std::span(middles));
  return simple.hit == 0 || simple.hit == simple.count ? simple : sum(std::span(dense));
}

}  // namespace pliant::undeformed
