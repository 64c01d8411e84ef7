#include "engine/remeshed/loads/loaded_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/remeshed/ghosts/record_loads.hpp"
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

/// Area times the outward unit normal.
PlaceVector<2> area_of(const std::array<PlaceVector<2>, 2>& x) {
  return {x[1][1] - x[0][1], x[0][0] - x[1][0]};
}
PlaceVector<3> area_of(const std::array<PlaceVector<3>, 3>& x) {
  return (x[1] - x[0]).cross(x[2] - x[0]) / 2;
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

template <int D>
std::array<std::int8_t, D> nothing_loaded() {
  std::array<std::int8_t, D> load;
  load.fill(no_load);
  return load;
}

/// Finds the loads on the components of a facet's area vector. A facet that cuts off an edge
/// belongs to two faces. A component along an axis then belongs to the face that a particle of the
/// facet sees along that axis.
template <class T, int D>
class FacetLoads {
 public:
  FacetLoads(const LatticeView<T, D>& view, const Shape& surface, const Boundaries<D>& boundaries)
      : view_(view), surface_(surface), boundaries_(boundaries) {}

  std::array<std::int8_t, D> of(const SurfacePiece<D>& piece) const {
    std::array<std::int8_t, D> load;
    for (int a = 0; a < D; ++a) load[a] = along(piece, a);
    return load;
  }

 private:
  std::int8_t along(const SurfacePiece<D>& piece, int axis) const {
    for (const Crossing<D>& crossing : piece) {
      const int step = crossing.outside->cell[axis] - crossing.inside->cell[axis];
      if (step == 0) continue;
      SurfaceNode<D> beyond = *crossing.inside;
      beyond.cell[axis] += step;
      beyond.slot = view_.population.layout.slot(view_.body.lattice.wrapped(beyond.cell));
      beyond.phi = view_.fields.get(Field::level_set)[beyond.slot];
      beyond.place[axis] += step * view_.body.lattice.spacing;
      if (beyond.phi >= 0) return at(Crossing<D>{crossing.inside, &beyond});
    }
    return at(piece[0]);
  }

  std::int8_t at(const Crossing<D>& crossing) const {
    const double fraction = crossing.fraction();
    const PlaceVector<D> place = crossing.place();
    Point<D> start;
    for (int a = 0; a < D; ++a) {
      const T* moved = view_.fields.get(Field::displacement, a);
      start[a] = place[a] - (1 - fraction) * moved[crossing.inside->slot] -
                 fraction * moved[crossing.outside->slot];
    }
    return face_at<D>(boundaries_, surface_, start).load;
  }

  const LatticeView<T, D>& view_;
  const Shape& surface_;
  const Boundaries<D>& boundaries_;
};

/// Force of the loads on the components of an area vector [N, in 2D N/m].
template <int D>
PlaceVector<D> force_of(const std::array<std::int8_t, D>& load, const PlaceVector<D>& area,
                        const BoundaryValues<D>& values) {
  PlaceVector<D> force = PlaceVector<D>::Zero();
  for (int i = 0; i < D; ++i) {
    if (load[i] < 0 || std::find(load.begin(), load.begin() + i, load[i]) != load.begin() + i) {
      continue;
    }
    PlaceVector<D> part = PlaceVector<D>::Zero();
    for (int a = i; a < D; ++a) part[a] = load[a] == load[i] ? area[a] : 0;
    force -= values.pressure[load[i]] * part;
    for (int a = 0; a < D; ++a) force[a] += part.norm() * values.traction[load[i]][a];
  }
  return force;
}

}  // namespace

template <class T, int D>
void find_loaded_facets(const LatticeView<T, D>& view, int block, const Shape& surface,
                        const Boundaries<D>& boundaries, std::vector<LoadedFacet<D>>& facets) {
  facets.clear();
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
    facet.load = loads.of(piece);
    if (facet.load != nothing_loaded<D>()) facets.push_back(facet);
  };
  const auto phi = level_set_of<T, D>(view);
  const Layout<D>& layout = view.population.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t, const Cell<D>& cell) {
    if (view.body.lattice.is_wrapped(cell) && cube.read(cell, phi)) cube.for_each_piece(add);
  });
}

template <class T, int D>
LoadsOnBlock<D> loads_on_block(const Body<T, D>& body, int block, int stage,
                               const BoundaryValues<D>& values) {
  const FieldStore<T, D>& state = body.stage[buffer_of(stage)];
  const FieldStore<T, D>& place = body.stage[drift_buffer_of(stage)];
  LoadsOnBlock<D> loads;
  for (const LoadedFacet<D>& facet : body.loaded[block]) {
    std::array<PlaceVector<D>, D> places;
    PlaceVector<D> velocity = PlaceVector<D>::Zero();
    for (int i = 0; i < D; ++i) {
      const FacetCorner<D>& corner = facet.corners[i];
      places[i] = between<T, D>(place, Field::drift, corner);
      for (int a = 0; a < D; ++a) places[i][a] += corner.place[a];
      velocity += between<T, D>(state, Field::velocity, corner) / D;
    }
    const PlaceVector<D> force = facet.share * force_of<D>(facet.load, area_of(places), values);
    for (int a = 0; a < D; ++a) loads.force[a] += force[a];
    loads.power += force.dot(velocity);
  }
  return loads;
}

template void find_loaded_facets<double, 2>(const LatticeView<double, 2>&, int, const Shape&,
                                            const Boundaries<2>&, std::vector<LoadedFacet<2>>&);
template LoadsOnBlock<2> loads_on_block<double, 2>(const Body<double, 2>&, int, int,
                                                   const BoundaryValues<2>&);
template void find_loaded_facets<float, 2>(const LatticeView<float, 2>&, int, const Shape&,
                                           const Boundaries<2>&, std::vector<LoadedFacet<2>>&);
template LoadsOnBlock<2> loads_on_block<float, 2>(const Body<float, 2>&, int, int,
                                                  const BoundaryValues<2>&);
template void find_loaded_facets<double, 3>(const LatticeView<double, 3>&, int, const Shape&,
                                            const Boundaries<3>&, std::vector<LoadedFacet<3>>&);
template LoadsOnBlock<3> loads_on_block<double, 3>(const Body<double, 3>&, int, int,
                                                   const BoundaryValues<3>&);
template void find_loaded_facets<float, 3>(const LatticeView<float, 3>&, int, const Shape&,
                                           const Boundaries<3>&, std::vector<LoadedFacet<3>>&);
template LoadsOnBlock<3> loads_on_block<float, 3>(const Body<float, 3>&, int, int,
                                                  const BoundaryValues<3>&);

}  // namespace pliant::remeshed
