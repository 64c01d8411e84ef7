#pragma once

#include <cstdint>
#include <vector>

#include "engine/point_based/surface/node_loads_of_facets.hpp"

namespace pliant::point_based {

/// A part of the area vector of a facet, and the node that bears it; -1: none.
template <int D>
struct BorneArea {
  std::int64_t node = -1;
  Point<D> area = {};
};

/// [node of the cloud] its share of the surface, outward [m^(D-1)]: that of a pressure on all of
/// it. `bearing(corners, area)` is a part of a flat facet that does not move with its corners.
template <class T, int D, class Bearing>
std::vector<Point<D>> surface_shares(const Body<T, D>& body, const Bearing& bearing) {
  std::vector<Point<D>> shares(body.particles);
  const auto add = [&](std::int64_t node, double weight, const Point<D>& area) {
    for (int a = 0; a < D; ++a) shares[node][a] += weight * area[a];
  };
  const BodySurface<D>& surface = body.surface;
  for (std::size_t f = 0; f < surface.facet.size(); ++f) {
    const PlaneFacet<D> facet = facet_of<D>(surface, f);
    const Corners<D>& corner = facet.corner;
    Point<D> area = facet.vector;
    const BorneArea<D> borne = bearing(corner, area);
    if (borne.node >= 0) {
      add(borne.node, 1, borne.area);
      area = difference<D>(area, borne.area);
    }
    undeformed::CurvedFacet<D> curved;
    if (surface.shape != nullptr && borne.node < 0) {
      curved = {*surface.shape, corner, surface.spacing};
    }
    std::array<LoadAtCorner<D>, D> loads;
    if (!curved.is_flat() && faces_of<D>(surface, corner, facet.normal).size() == 1) {
      loads = loads_on_parts<D>(corner, curved, [](const Point<D>&) { return true; });
    } else {
      if (!curved.is_flat()) area = curved.area();
      const auto part = shares_of_corners<D>(apex_of_half(surface, f));
      for (int v = 0; v < D; ++v) {
        for (int a = 0; a < D; ++a) loads[v].area[a] = part[v] * area[a];
      }
    }
    for (int v = 0; v < D; ++v) {
      share_out(body, surface.facet[f][v], loads[v],
                [&](std::int32_t slot, double weight, const LoadAtCorner<D>& load) {
                  add(body.number[slot], weight, load.area);
                });
    }
  }
  return shares;
}

}  // namespace pliant::point_based
