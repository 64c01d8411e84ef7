#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/lattice/point_algebra.hpp"
#include "engine/total_lagrangian/facet_loads.hpp"
#include "engine/total_lagrangian/load_shares.hpp"
#include "engine/total_lagrangian/setup.hpp"

// The surface of the undeformed body, cut from its cells simplex by simplex. Corners of facets lie
// on lines between particles, so the present surface follows from the particles alone.
namespace pliant::total_lagrangian {

namespace {

constexpr double smallest_area = 1e-9;  // [h^(D-1)]

template <int D>
Vertex<D> vertex(const Crossing<D>& crossing, double fraction) {
  Vertex<D> v{static_cast<std::int32_t>(crossing.inside->slot),
              static_cast<std::int32_t>(crossing.outside->slot),
              fraction,
              {}};
  Eigen::Map<PlaceVector<D>>(v.start.data()) =
      crossing.inside->place + fraction * (crossing.outside->place - crossing.inside->place);
  return v;
}

template <class T, int D>
class SurfaceMaker {
 public:
  SurfaceMaker(const Boundaries<D>& boundaries, Body<T, D>& body)
      : boundaries_(boundaries),
        body_(body),
        loads_(boundaries, body),
        pushes_(body.layout.slots()),
        smallest_(smallest_area * std::pow(body.lattice.spacing, D - 1)) {}

  // Inside corners must be particles. A corner of a facet next to an outside corner that is no
  // particle moves with the inside ones.
  void cut(const Cell<D>& cell) {
    const auto slots = body_.corners(cell);
    Cube<D> cube;
    for (int c = 0; c < (1 << D); ++c) {
      SurfaceNode<D>& node = cube[c];
      node.slot = slots[c];
      if (node.slot < 0) return;
      node.phi = body_.level_set[node.slot];
      if (node.phi < 0 && !body_.is_particle(node.slot)) return;
      for (int a = 0; a < D; ++a) {
        node.cell[a] = cell[a] + (c >> a & 1);
      }
      Eigen::Map<PlaceVector<D>>(node.place.data()) =
          Eigen::Map<const PlaceVector<D>>(body_.place(node.slot, node.cell).data());
    }
    loaded_.clear();
    for_each_piece<D>(cube, [&](const SurfacePiece<D>& piece) {
      const Facet<D> made = facet(piece);
      if (norm<D>(area_vector(body_, made)) <= smallest_) return;
      body_.facets.push_back(made);
      loads_.add(places_in_cell(piece, made, cell), loaded_);
    });
    if (lies_on_a_face(cube)) equalise_shares(cube);
    for (const LoadedFacet<D>& facet : loaded_) push(cube, facet);
  }

  // Finds which particles the patches load.
  void distribute_loads() {
    body_.nodal_loads.assign(body_.layout.blocks().size(), {});
    for (std::size_t b = 0; b < body_.nodal_loads.size(); ++b) {
      NodalLoads& to = body_.nodal_loads[b];
      body_.layout.for_each_slot(body_.layout.blocks()[b], [&](std::int64_t p, const Cell<D>&) {
        if (pushes_[p].empty()) return;
        to.slot.push_back(static_cast<std::int32_t>(p));
        for (const auto& [patch, weight] : pushes_[p]) {
          to.patch.push_back(patch);
          to.weight.push_back(weight);
        }
        to.begin.push_back(static_cast<std::int32_t>(to.patch.size()));
      });
    }
  }

 private:
  Facet<D> facet(const SurfacePiece<D>& piece) const {
    Facet<D> facet;
    Point<D> centre = {};
    for (int v = 0; v < D; ++v) {
      facet.vertex[v] = vertex(piece[v], loads_.way_out(piece[v]));
      if (!body_.is_particle(facet.vertex[v].second))
        facet.vertex[v].second = facet.vertex[v].first;
      facet.vertex[v].start = loads_.onto_surface(facet.vertex[v].start);
      for (int a = 0; a < D; ++a) centre[a] += facet.vertex[v].start[a] / D;
    }
    facet.free = !loads_.on_a_wall(centre);
    return facet;
  }

  static PlacesInCell<D> places_in_cell(const SurfacePiece<D>& piece, const Facet<D>& made,
                                        const Cell<D>& cell) {
    PlacesInCell<D> places;
    for (int v = 0; v < D; ++v) {
      const auto& [inside, outside] = std::pair{piece[v].inside->cell, piece[v].outside->cell};
      for (int a = 0; a < D; ++a) {
        places[v][a] = inside[a] - cell[a] + made.vertex[v].along * (outside[a] - inside[a]);
      }
    }
    return places;
  }

  /// Whether the facets lie on a face of the cell, which then holds nothing of the body.
  bool lies_on_a_face(const Cube<D>& cube) const {
    return std::ranges::none_of(cube, [this](const SurfaceNode<D>& corner) {
      return corner.phi >= 0 && body_.is_particle(corner.slot);
    });
  }

  // (TL.27): all facets with the same uniform load get the same shares.
  void equalise_shares(const Cube<D>& cube) {
    for (int k = 0; k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      if (boundaries_.pressures[k].depends_on_place()) continue;
      double area = 0;
      PlaceVector<D> moment = PlaceVector<D>::Zero();
      for (const LoadedFacet<D>& facet : loaded_) {
        if (facet.pressure != k) continue;
        area += facet.area;
        moment += Eigen::Map<const PlaceVector<D>>(facet.moment.data());
      }
      if (area == 0) continue;
      const Weights<D> shares = linear_shares<D>(cube, moment / area);
      for (LoadedFacet<D>& facet : loaded_) {
        if (facet.pressure == k) facet.weights = shares;
      }
    }
    for (LoadedFacet<D>& facet : loaded_) {
      if (!boundaries_.pressures[facet.pressure].depends_on_place()) continue;
      const Eigen::Map<const PlaceVector<D>> moment(facet.moment.data());
      facet.weights = linear_shares<D>(cube, moment / facet.area);
    }
  }

  // (TL.27). Corners that are not particles pass their share to the others.
  void push(const Cube<D>& cube, const LoadedFacet<D>& facet) {
    double sum = 0;
    for (int c = 0; c < (1 << D); ++c) {
      if (body_.is_particle(cube[c].slot)) sum += facet.weights[c];
    }
    for (int c = 0; c < (1 << D); ++c) {
      if (!body_.is_particle(cube[c].slot)) continue;
      pushes_[cube[c].slot].push_back({facet.patch, facet.weights[c] / sum});
    }
  }

  const Boundaries<D>& boundaries_;
  Body<T, D>& body_;
  FacetLoads<T, D> loads_;
  std::vector<std::vector<std::pair<int, double>>> pushes_;  // [slot]
  std::vector<LoadedFacet<D>> loaded_;                       // of the cell that is being cut
  double smallest_;
};

}  // namespace

template <class T, int D>
void make_surface(const Boundaries<D>& boundaries, Body<T, D>& body) {
  SurfaceMaker<T, D> maker(boundaries, body);
  body.first_patch = {0};
  for (const Block<D>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t, const Cell<D>& cell) { maker.cut(cell); });
    body.first_patch.push_back(static_cast<int>(body.patches.size()));
  }
  body.patch_force.assign(body.patches.size(), {});
  maker.distribute_loads();
}

template void make_surface<double, 2>(const Boundaries<2>&, Body<double, 2>&);
template void make_surface<double, 3>(const Boundaries<3>&, Body<double, 3>&);
template void make_surface<float, 2>(const Boundaries<2>&, Body<float, 2>&);
template void make_surface<float, 3>(const Boundaries<3>&, Body<float, 3>&);

}  // namespace pliant::total_lagrangian
