#include "engine/remeshed/observe/surface_area.hpp"

#include <cmath>

#include "engine/geometry/signed_distance.hpp"
#include "engine/remeshed/loads/facet_loads.hpp"
#include "engine/remeshed/loads/loaded_surface.hpp"
#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

namespace {

/// Area of what a facet with this area vector stands for.
template <int D>
double size_of(const PlaceVector<D>& area, const FacetLoad<D>& facet) {
  if (facet.faces == 1) return area.norm();
  const PlaceVector<D> along = along_faces<D>(area, facet.normal);
  double size = 0;
  for (int i = 0; i < facet.faces; ++i) size += std::abs(along[i]);
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
        sum += size_of<D>(area_of(places), has_known_edges ? facets.of(piece) : FacetLoad<D>{});
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
