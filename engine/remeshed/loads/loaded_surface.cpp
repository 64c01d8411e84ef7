#include "engine/remeshed/loads/loaded_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "engine/lattice/column.hpp"
#include "engine/remeshed/loads/facet_loads.hpp"
#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

namespace {

/// The part of a segment or triangle in which a linear function is positive; `values` are those at
/// its corners.
template <int D>
double positive_share(const std::array<double, D>& values) {
  const auto positive = std::count_if(values.begin(), values.end(), [](double v) { return v > 0; });
  if (positive == 0 || positive == D) return positive == 0 ? 0 : 1;
  const auto share_at = [&values](int corner) {
    double share = 1;
    for (int i = 0; i < D; ++i) {
      if (i != corner) share *= values[corner] / (values[corner] - values[i]);
    }
    return share;
  };
  for (int i = 0; i < D; ++i) {
    if (positive == 1 && values[i] > 0) return share_at(i);
    if (positive > 1 && values[i] <= 0) return 1 - share_at(i);
  }
  return 1;
}

/// A vector field, interpolated between two slots.
template <class T, int D>
PlaceVector<D> between(const FieldStore<T, D>& fields, Field field, const FacetCorner<D>& corner) {
  PlaceVector<D> value;
  for (int a = 0; a < D; ++a) {
    const T* of = fields.get(field, a);
    value[a] = (1 - corner.fraction) * of[corner.inside] + corner.fraction * of[corner.outside];
  }
  return value;
}

/// Force of the loads at x on a facet with the area vector `area`. A traction acts on the size of a
/// part along the normal of its face: dents of {phi = 0} in a flat face are no more area.
template <int D>
FacetForce<D> force_of(const FacetParts<D>& facet, const PlaceVector<D>& area, const Point<D>& x,
                       const BoundaryValues<D>& values) {
  FacetForce<D> force{PlaceVector<D>::Zero(), PlaceVector<D>::Zero(), column<D>(x)};
  for_each_loaded_part<D>(
      facet, area, [&](int load, const PlaceVector<D>& part, const PlaceVector<D>& n) {
        const PlaceVector<D> traction = part.dot(n) * column<D>(values.traction_at(load, x));
        force.whole += traction - values.pressure_at(load, x) * part;
        force.shear += traction - traction.dot(n) * n;
      });
  return force;
}

template <int D>
bool is_loaded(const FacetParts<D>& facet) {
  return std::ranges::any_of(facet.parts, [](const FacetPart<D>& part) { return part.load >= 0; });
}

template <int D>
bool is_under_traction(const LoadedFacet<D>& facet, const Boundaries<D>& boundaries) {
  return std::ranges::any_of(facet.parts.parts, [&](const FacetPart<D>& part) {
    return boundaries.is_traction(part.load);
  });
}

}  // namespace

template <class T, int D>
void find_loaded_facets(const LatticeView<T, D>& view, int block, const Shape& surface,
                        const Boundaries<D>& boundaries, std::vector<LoadedFacet<D>>& facets,
                        std::vector<ShearPatch<D>>& patches) {
  facets.clear();
  patches.clear();
  if (boundaries.pressures.empty()) return;
  const FacetLoads<T, D> loads(view, surface, boundaries);
  SurfaceCube<T, D> cube(view);
  const auto add = [&](const SurfacePiece<D>& piece) {
    LoadedFacet<D> facet;
    std::array<double, D> before_walls;
    for (int i = 0; i < D; ++i) {
      FacetCorner<D>& corner = facet.corners[i];
      corner = {static_cast<std::int32_t>(piece[i].inside->slot),
                static_cast<std::int32_t>(piece[i].outside->slot),
                piece[i].fraction(),
                {}};
      const PlaceVector<D> place = piece[i].place();
      for (int a = 0; a < D; ++a) {
        corner.place[a] = place[a];
      }
      before_walls[i] = boundaries.nearest_wall(corner.place).second;
    }
    facet.share = positive_share<D>(before_walls);
    if (facet.share == 0) return;
    facet.parts = loads.of(piece);
    if (is_loaded(facet.parts)) facets.push_back(facet);
  };
  const auto phi = level_set_of<T, D>(view);
  const Layout<D>& layout = view.population.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t, const Cell<D>& cell) {
    if (!view.body.lattice.is_wrapped(cell) || !cube.read(cell, phi)) return;
    const std::size_t first = facets.size();
    cube.for_each_piece(add);
    if (std::any_of(facets.begin() + first, facets.end(), [&](const LoadedFacet<D>& facet) {
          return is_under_traction(facet, boundaries);
        })) {
      ShearPatch<D>& patch = patches.emplace_back();
      patch.first_facet = static_cast<std::int32_t>(first);
      patch.facet_count = static_cast<std::int32_t>(facets.size() - first);
    }
  });
}

template <class T, int D>
FacetForce<D> force_at_stage(const Body<T, D>& body, const LoadedFacet<D>& facet, int stage,
                             const BoundaryValues<D>& values) {
  const FieldStore<T, D>& place = body.stage[drift_buffer_of(stage)];
  std::array<PlaceVector<D>, D> places;
  PlaceVector<D> middle = PlaceVector<D>::Zero();
  for (int i = 0; i < D; ++i) {
    const FacetCorner<D>& corner = facet.corners[i];
    places[i] = between<T, D>(place, Field::drift, corner) + column<D>(corner.place);
    middle += places[i] / D;
  }
  FacetForce<D> force = force_of<D>(facet.parts, area_of(places), as_point<D>(middle), values);
  force.whole *= facet.share;
  force.shear *= facet.share;
  return force;
}

template <class T, int D>
LoadsOnBlock<D> loads_on_block(const Body<T, D>& body, int block, int stage,
                               const BoundaryValues<D>& values) {
  const FieldStore<T, D>& state = body.stage[buffer_of(stage)];
  LoadsOnBlock<D> loads;
  for (const LoadedFacet<D>& facet : body.loaded[block]) {
    PlaceVector<D> velocity = PlaceVector<D>::Zero();
    for (const FacetCorner<D>& corner : facet.corners) {
      velocity += between<T, D>(state, Field::velocity, corner) / D;
    }
    const FacetForce<D> force = force_at_stage(body, facet, stage, values);
    loads.force.add(as_point<D>(force.place), as_point<D>(force.whole));
    loads.power += force.whole.dot(velocity);
  }
  return loads;
}

template void find_loaded_facets<double, 2>(const LatticeView<double, 2>&, int, const Shape&,
                                            const Boundaries<2>&, std::vector<LoadedFacet<2>>&,
                                            std::vector<ShearPatch<2>>&);
template FacetForce<2> force_at_stage<double, 2>(const Body<double, 2>&, const LoadedFacet<2>&, int,
                                                 const BoundaryValues<2>&);
template LoadsOnBlock<2> loads_on_block<double, 2>(const Body<double, 2>&, int, int,
                                                   const BoundaryValues<2>&);
template void find_loaded_facets<float, 2>(const LatticeView<float, 2>&, int, const Shape&,
                                           const Boundaries<2>&, std::vector<LoadedFacet<2>>&,
                                           std::vector<ShearPatch<2>>&);
template FacetForce<2> force_at_stage<float, 2>(const Body<float, 2>&, const LoadedFacet<2>&, int,
                                                const BoundaryValues<2>&);
template LoadsOnBlock<2> loads_on_block<float, 2>(const Body<float, 2>&, int, int,
                                                  const BoundaryValues<2>&);
template void find_loaded_facets<double, 3>(const LatticeView<double, 3>&, int, const Shape&,
                                            const Boundaries<3>&, std::vector<LoadedFacet<3>>&,
                                            std::vector<ShearPatch<3>>&);
template FacetForce<3> force_at_stage<double, 3>(const Body<double, 3>&, const LoadedFacet<3>&, int,
                                                 const BoundaryValues<3>&);
template LoadsOnBlock<3> loads_on_block<double, 3>(const Body<double, 3>&, int, int,
                                                   const BoundaryValues<3>&);
template void find_loaded_facets<float, 3>(const LatticeView<float, 3>&, int, const Shape&,
                                           const Boundaries<3>&, std::vector<LoadedFacet<3>>&,
                                           std::vector<ShearPatch<3>>&);
template FacetForce<3> force_at_stage<float, 3>(const Body<float, 3>&, const LoadedFacet<3>&, int,
                                                const BoundaryValues<3>&);
template LoadsOnBlock<3> loads_on_block<float, 3>(const Body<float, 3>&, int, int,
                                                  const BoundaryValues<3>&);

}  // namespace pliant::remeshed
