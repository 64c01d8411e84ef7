#include "engine/remeshed/observe/surface_area.hpp"

#include <cmath>

#include "engine/geometry/signed_distance.hpp"
#include "engine/remeshed/loads/facet_loads.hpp"
#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

namespace {

/// The area of what a facet stands for, over its own.
template <int D>
double relative_size(const FacetParts<D>& facet) {
  double size = 0;
  for (int k = 0; k < facet.count; ++k) size += column<D>(facet.parts[k].area).norm();
  return size;
}

}  // namespace

template <class T, int D>
double surface_area(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                    const Shape& initial) {
  const FacetLoads<T, D> facets(view, initial, boundaries);
  const bool has_known_edges = !contains_mesh(initial);
  double sum = 0;
  for_each_surface_piece(
      view, boundaries,
      [&](const SurfacePiece<D>& piece, const std::array<PlaceVector<D>, D>& places) {
        sum += area_of(places).norm() * (has_known_edges ? relative_size<D>(facets.of(piece)) : 1);
      });
  return sum;
}

template double surface_area<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&,
                                        const Shape&);
template double surface_area<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&,
                                        const Shape&);
template double surface_area<float, 2>(const LatticeView<float, 2>&, const Boundaries<2>&,
                                       const Shape&);
template double surface_area<float, 3>(const LatticeView<float, 3>&, const Boundaries<3>&,
                                       const Shape&);

}  // namespace pliant::remeshed
