#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/lattice/column.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/total_lagrangian/body.hpp"
#include "engine/total_lagrangian/load_shares.hpp"
#include "engine/undeformed/contact/curved_facet.hpp"
#include "engine/undeformed/contact/surface_place.hpp"

namespace pliant::total_lagrangian {

/// The part of a facet under one load.
template <int D>
struct LoadedFacet {
  int patch, pressure;
  Weights<D> weights;  ///< [corner of the cell] proportional to the shares
  double area;         ///< loaded area [m^(D-1)]
  Point<D> moment;     ///< integral of x over the area [m^D]
};

/// Finds which parts of the facets of a body the loads act on.
template <class T, int D>
class FacetLoads {
 public:
  FacetLoads(const Boundaries<D>& boundaries, Body<T, D>& body)
      : boundaries_(boundaries), body_(body) {
    // Distances to meshes are expensive, and edges of meshes are seldom as sharp as those of boxes.
    if (body.source != nullptr && !contains_mesh(body.source->geometry)) {
      shape_ = &body.source->geometry;
    }
  }

  bool on_a_wall(const Point<D>& x) const {
    return boundaries_.nearest_wall(x).second <= on_wall * body_.lattice.spacing;
  }

  /// The place on the surface of the body next to a corner of a facet, which lies on a line between
  /// two particles, on which phi is linear, (TL.32).
  Point<D> onto_surface(const Point<D>& x) const {
    return shape_ == nullptr ? x : undeformed::onto_surface<D>(*shape_, x, body_.lattice.spacing);
  }

  /// Share of the way from a particle inside to a place outside where the line leaves the body:
  /// that at which the linear phi is zero, except for particles on a face, along which the line
  /// may continue up to an edge.
  double way_out(const Crossing<D>& crossing) const {
    const double linear = crossing.fraction();
    if (shape_ == nullptr || linear > 1e-6) return linear;
    const double along = undeformed::way_along_face<D>(
        *shape_, pliant::as_point<D>(crossing.inside->place),
        pliant::as_point<D>(crossing.outside->place), body_.lattice.spacing);
    return std::max(linear, along);
  }

  /// Adds patches to the body for each load on its last facet, and appends their shares to
  /// `loaded`: one patch, or if the load depends on the place, one for each corner of the facet.
  void add(const PlacesInCell<D>& places, std::vector<LoadedFacet<D>>& loaded) {
    if (boundaries_.pressures.empty()) return;
    const Facet<D>& facet = body_.facets.back();
    Point<D> normal = area_vector(body_, facet);
    const double area = norm<D>(normal);
    for (double& component : normal) component /= area;
    const std::vector<FaceOfFacet> faces = faces_of(facet, normal);
    for (int k = 0; k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      const bool varies = boundaries_.pressures[k].depends_on_place();
      for (int corner = varies ? 0 : whole_facet; corner < (varies ? D : 0); ++corner) {
        LoadOnFacet on_facet = load_on_facet(k, corner, places, normal, faces);
        if (on_facet.loaded.area == 0) break;
        for (double& component : on_facet.moment) component *= area;
        loaded.push_back({static_cast<int>(body_.patches.size()), k, on_facet.weights,
                          area * on_facet.loaded.area, on_facet.moment});
        body_.patches.push_back(patch(k, corner, on_facet.loaded, normal, area));
      }
    }
  }

 private:
  using FaceOfFacet = undeformed::FaceOfFacet<D>;

  struct LoadOnFacet {
    undeformed::LoadedPart<D> loaded;  ///< relative to the area of the facet
    Weights<D> weights = {};           ///< [corner of the cell] proportional to the shares
    Point<D> moment = {};              ///< integral of x over the loaded part, over the area [m]
    int count = 0, hit = 0;            ///< places, and those of them where the load acts
  };

  // The share of a corner counts each place by the linear shape function of that corner.
  static double share_of(int corner, const Barycentric<D>& at) {
    return corner == whole_facet ? 1 : at[corner];
  }

  LoadOnFacet load_on_facet(int number, int corner, const PlacesInCell<D>& places,
                            const Point<D>& normal, const std::vector<FaceOfFacet>& faces) const {
    const SurfacePressure<D>& pressure = boundaries_.pressures[number];
    LoadOnFacet load =
        undeformed::sum_over_facet<D>([&](std::span<const Barycentric<D>> places_on_facet) {
          LoadOnFacet sum;
          for (const Barycentric<D>& at : places_on_facet) {
            add_place(pressure, corner, places, at, normal, faces, sum);
          }
          return sum;
        });
    if (load.hit == 0) return load;
    if (load.hit == load.count) {
      load.weights = {};
      const Point<D> out =
          pressure.is_traction() ? Point<D>{} : lever(load.loaded.gap / load.hit, normal);
      for_each_gauss_point<D>([&](const Barycentric<D>& at, double weight) {
        add_weights<D>(places, at, out, share_of(corner, at) * weight, load.weights);
      });
    }
    load.loaded.area /= load.count;
    for (double& component : load.loaded.vector) component /= load.count;
    for (double& component : load.moment) component /= load.count;
    return load;
  }

  // Adds the part of the load at one place of the last facet.
  void add_place(const SurfacePressure<D>& pressure, int corner, const PlacesInCell<D>& places,
                 const Barycentric<D>& at, const Point<D>& normal,
                 const std::vector<FaceOfFacet>& faces, LoadOnFacet& sum) const {
    ++sum.count;
    const Point<D> x = place(body_.facets.back(), at);
    if (on_a_wall(x)) return;
    undeformed::LoadedPart<D> part = loaded_part(x, pressure, normal, faces);
    if (part.area == 0) return;
    ++sum.hit;
    part.area *= share_of(corner, at);
    for (double& component : part.vector) component *= share_of(corner, at);
    const double share = pressure.is_traction() ? part.area : norm<D>(part.vector);
    sum.loaded.area += share;
    sum.loaded.gap += part.gap;
    for (int a = 0; a < D; ++a) {
      sum.loaded.vector[a] += part.vector[a];
      sum.moment[a] += share * x[a];
    }
    add_weights<D>(places, at, {}, share, sum.weights);
  }

  // (TL.32): how far in front of a facet with a mean `gap` [m] to the surface a pressure acts [h].
  Point<D> lever(double gap, const Point<D>& normal) const {
    Point<D> out = {};
    if (std::abs(gap) <= no_depth * body_.lattice.spacing) return out;
    for (int a = 0; a < D; ++a) out[a] = D * gap * normal[a] / body_.lattice.spacing;
    return out;
  }

  // The patch of the last facet.
  SurfacePatch<D> patch(int pressure, int corner, const undeformed::LoadedPart<D>& loaded,
                        const Point<D>& normal, double area) const {
    SurfacePatch<D> made = {static_cast<int>(body_.facets.size()) - 1, loaded.area, pressure,
                            corner};
    if (boundaries_.pressures[pressure].is_traction()) return made;
    made.share = dot<D>(loaded.vector, normal);
    Point<D> aside = loaded.vector;
    for (int a = 0; a < D; ++a) aside[a] -= made.share * normal[a];
    if (dot<D>(aside, aside) < no_vector * no_vector) return made;
    // The sides of a sliver do not give directions in its plane.
    if (area < sliver * std::pow(body_.lattice.spacing, D - 1)) return made;
    const auto& x = body_.facets.back().vertex;
    for (int i = 1; i < D; ++i) {
      made.aside[i - 1] = dot<D>(aside, difference<D>(x[i].start, x[0].start));
    }
    return made;
  }

  // Facets that lie on the surface have one face.
  std::vector<FaceOfFacet> faces_of(const Facet<D>& facet, const Point<D>& normal) const {
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
                                        const std::vector<FaceOfFacet>& faces) const {
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

  static constexpr double on_wall = 1e-5;    // [h]
  static constexpr double no_depth = 1e-9;   // [h]
  static constexpr double no_vector = 1e-9;  // relative to the area of a facet
  static constexpr double sliver = 1e-6;     // [h^(D-1)]

  const Boundaries<D>& boundaries_;
  Body<T, D>& body_;
  const Shape* shape_ = nullptr;  // null where distances are expensive
};

}  // namespace pliant::total_lagrangian
