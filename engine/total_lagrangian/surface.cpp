#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/lattice/point_algebra.hpp"
#include "engine/total_lagrangian/load_shares.hpp"
#include "engine/total_lagrangian/setup.hpp"
#include "engine/undeformed/contact/surface_place.hpp"

// The surface of the undeformed body, cut from its cells simplex by simplex. Corners of facets lie
// on lines between particles, so the present surface follows from the particles alone.
namespace pliant::total_lagrangian {

namespace {

using undeformed::FaceOfFacet;

constexpr double on_wall = 1e-5;        // [h]
constexpr double no_depth = 1e-9;       // [h]
constexpr double smallest_area = 1e-9;  // [h^(D-1)]
constexpr double no_vector = 1e-9;      // relative to the area of a facet

template <int D>
Vertex<D> vertex(const Crossing<D>& crossing) {
  Vertex<D> v{static_cast<std::int32_t>(crossing.inside->slot),
              static_cast<std::int32_t>(crossing.outside->slot),
              crossing.fraction(),
              {}};
  Eigen::Map<PlaceVector<D>>(v.start.data()) = crossing.place();
  return v;
}

template <int D>
double length(const Point<D>& x) {
  return std::sqrt(dot<D>(x, x));
}

template <class T, int D>
class SurfaceMaker {
 public:
  SurfaceMaker(const Boundaries<D>& boundaries, Body<T, D>& body)
      : boundaries_(boundaries),
        body_(body),
        pushes_(body.layout.slots()),
        smallest_(smallest_area * std::pow(body.lattice.spacing, D - 1)) {
    // Distances to meshes are expensive, and edges of meshes are seldom as sharp as those of boxes.
    if (body.source != nullptr && !contains_mesh(body.source->geometry)) {
      shape_ = &body.source->geometry;
    }
  }

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
      if (length<D>(area_vector(body_, made)) <= smallest_) return;
      body_.facets.push_back(made);
      load(places_in_cell(piece, cell));
    });
    if (lies_on_a_face(cube)) equalise_shares(cube);
    for (const LoadedFacet& facet : loaded_) push(cube, facet);
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
  struct LoadedFacet {
    int patch, pressure;
    Weights<D> weights;  ///< [corner of the cell] proportional to the shares
    double area;         ///< loaded area [m^(D-1)]
    Point<D> moment;     ///< integral of x over the area [m^D]
  };

  Facet<D> facet(const SurfacePiece<D>& piece) const {
    Facet<D> facet;
    Point<D> centre = {};
    for (int v = 0; v < D; ++v) {
      facet.vertex[v] = vertex(piece[v]);
      if (!body_.is_particle(facet.vertex[v].second))
        facet.vertex[v].second = facet.vertex[v].first;
      for (int a = 0; a < D; ++a) centre[a] += facet.vertex[v].start[a] / D;
    }
    facet.free = !on_a_wall(centre);
    return facet;
  }

  bool on_a_wall(const Point<D>& x) const {
    return boundaries_.nearest_wall(x).second <= on_wall * body_.lattice.spacing;
  }

  static PlacesInCell<D> places_in_cell(const SurfacePiece<D>& piece, const Cell<D>& cell) {
    PlacesInCell<D> places;
    for (int v = 0; v < D; ++v) {
      const auto& [inside, outside] = std::pair{piece[v].inside->cell, piece[v].outside->cell};
      for (int a = 0; a < D; ++a) {
        places[v][a] = inside[a] - cell[a] + piece[v].fraction() * (outside[a] - inside[a]);
      }
    }
    return places;
  }

  // Applies all loads to the last facet.
  void load(const PlacesInCell<D>& places) {
    const Facet<D>& facet = body_.facets.back();
    Point<D> normal = area_vector(body_, facet);
    const double area = length<D>(normal);
    for (double& component : normal) component /= area;
    const std::vector<FaceOfFacet<D>> faces = faces_of(facet, normal);
    for (int k = 0; k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      const SurfacePressure<D>& pressure = boundaries_.pressures[k];
      int count = 0, hit = 0;
      undeformed::LoadedPart<D> loaded;
      Weights<D> weights = {};
      Point<D> moment = {};
      for_each_sample<D>([&](const Barycentric<D>& at) {
        ++count;
        const Point<D> x = place(facet, at);
        if (on_a_wall(x)) return;
        const undeformed::LoadedPart<D> part = loaded_part(x, pressure, normal, faces);
        if (part.area == 0) return;
        const double share = pressure.is_traction() ? part.area : length<D>(part.vector);
        ++hit;
        loaded.area += share;
        for (int a = 0; a < D; ++a) {
          loaded.vector[a] += part.vector[a];
          moment[a] += share * x[a];
        }
        add_weights<D>(places, at, share, weights);
      });
      if (hit == 0) continue;
      if (hit == count) {
        weights = {};
        for_each_gauss_point<D>([&](const Barycentric<D>& at, double weight) {
          add_weights<D>(places, at, weight, weights);
        });
      }
      for (double& component : moment) component *= area / count;
      loaded_.push_back(
          {static_cast<int>(body_.patches.size()), k, weights, area * loaded.area / count, moment});
      loaded.area /= count;
      for (double& component : loaded.vector) component /= count;
      body_.patches.push_back(patch(k, loaded, normal));
    }
  }

  // The patch of the last facet.
  SurfacePatch<D> patch(int pressure, const undeformed::LoadedPart<D>& loaded,
                        const Point<D>& normal) const {
    SurfacePatch<D> made = {static_cast<int>(body_.facets.size()) - 1, loaded.area, pressure};
    if (boundaries_.pressures[pressure].is_traction()) return made;
    made.share = dot<D>(loaded.vector, normal);
    Point<D> aside = loaded.vector;
    for (int a = 0; a < D; ++a) aside[a] -= made.share * normal[a];
    if (dot<D>(aside, aside) < no_vector * no_vector) return made;
    const auto& corner = body_.facets.back().vertex;
    for (int i = 1; i < D; ++i) {
      made.aside[i - 1] = dot<D>(aside, difference<D>(corner[i].start, corner[0].start));
    }
    return made;
  }

  // Facets that lie on the surface have one face.
  std::vector<FaceOfFacet<D>> faces_of(const Facet<D>& facet, const Point<D>& normal) const {
    if (shape_ == nullptr || boundaries_.pressures.empty()) return {{normal}};
    Barycentric<D> centre;
    centre.fill(1. / D);
    const Point<D> middle = place(facet, centre);
    const double h = body_.lattice.spacing;
    if (std::abs(signed_distance(*shape_, padded<D>(middle), D)) <= no_depth * h) return {{normal}};
    return undeformed::faces_of_facet<D>(*shape_, middle, normal, h);
  }

  // (TL.29)
  undeformed::LoadedPart<D> loaded_part(const Point<D>& x, const SurfacePressure<D>& load,
                                        const Point<D>& normal,
                                        const std::vector<FaceOfFacet<D>>& faces) const {
    return undeformed::loaded_part<D>(
        shape_, x, normal, faces, body_.lattice.spacing,
        [&](const Point<D>& at) { return load.acts_at(at) && !on_a_wall(at); });
  }

  static Point<D> place(const Facet<D>& facet, const Barycentric<D>& at) {
    Point<D> x = {};
    for (int v = 0; v < D; ++v) {
      for (int a = 0; a < D; ++a) x[a] += at[v] * facet.vertex[v].start[a];
    }
    return x;
  }

  /// Whether the facets lie on a face of the cell, which then holds nothing of the body.
  bool lies_on_a_face(const Cube<D>& cube) const {
    return std::ranges::none_of(cube, [this](const SurfaceNode<D>& corner) {
      return corner.phi >= 0 && body_.is_particle(corner.slot);
    });
  }

  // (TL.27): all facets with the same load get the same shares.
  void equalise_shares(const Cube<D>& cube) {
    for (int k = 0; k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      double area = 0;
      PlaceVector<D> moment = PlaceVector<D>::Zero();
      for (const LoadedFacet& facet : loaded_) {
        if (facet.pressure != k) continue;
        area += facet.area;
        moment += Eigen::Map<const PlaceVector<D>>(facet.moment.data());
      }
      if (area == 0) continue;
      const Weights<D> shares = linear_shares<D>(cube, moment / area);
      for (LoadedFacet& facet : loaded_) {
        if (facet.pressure == k) facet.weights = shares;
      }
    }
  }

  // (TL.27). Corners that are not particles pass their share to the others.
  void push(const Cube<D>& cube, const LoadedFacet& facet) {
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
  const Shape* shape_ = nullptr;                             // null where distances are expensive
  std::vector<std::vector<std::pair<int, double>>> pushes_;  // [slot]
  std::vector<LoadedFacet> loaded_;                          // of the cell that is being cut
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
