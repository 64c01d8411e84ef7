#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/point_based/body.hpp"
#include "engine/point_based/surface/contact_surface.hpp"
#include "engine/point_based/surface/rectangles.hpp"
#include "engine/undeformed/contact/curved_facet.hpp"
#include "engine/undeformed/contact/surface_place.hpp"
#include "engine/undeformed/facet_places.hpp"

/// The shares of nodes in the facets under one load.
namespace pliant::point_based {

/// Whether a wall that holds bodies is at this place of a surface with the spacing `h` [m].
template <int D>
bool lies_on_a_wall(const Boundaries<D>& boundaries, const Point<D>& x, double h) {
  constexpr double on_face = 1e-5;  // [h]
  return boundaries.nearest_wall(x).second < on_face * h;
}

template <int D>
using Corners = std::array<Point<D>, D>;

template <int D>
struct PlaneFacet {
  Corners<D> corner;
  Point<D> vector;  ///< area vector [m^(D-1)]
  Point<D> normal;
  double area;
};

template <int D>
PlaneFacet<D> facet_of(const BodySurface<D>& surface, std::size_t number) {
  PlaneFacet<D> facet;
  for (int v = 0; v < D; ++v) facet.corner[v] = surface.start[surface.facet[number][v]];
  facet.vector = undeformed::area_vector<D>(facet.corner);
  facet.area = norm<D>(facet.vector);
  facet.normal = facet.vector;
  for (double& component : facet.normal) component /= facet.area;
  return facet;
}

template <int D>
using FacesOfFacet = std::vector<undeformed::FaceOfFacet<D>>;

template <int D>
FacesOfFacet<D> faces_of(const BodySurface<D>& surface, const Corners<D>& corner,
                         const Point<D>& normal) {
  if (surface.shape == nullptr) return {{normal}};
  return undeformed::faces_of_facet<D>(*surface.shape, undeformed::middle_of<D>(corner), normal,
                                       surface.spacing);
}

/// The loaded part of a facet: a mean over the part of the surface that the facet represents,
/// (TL.29).
template <int D>
undeformed::LoadedPart<D> loaded_part(const Boundaries<D>& boundaries,
                                      const SurfacePressure<D>& load, const BodySurface<D>& surface,
                                      const Corners<D>& corner, const Point<D>& normal,
                                      const FacesOfFacet<D>& faces) {
  const auto acts_at = [&](const Point<D>& x) {
    return load.acts_at(x) && !lies_on_a_wall<D>(boundaries, x, surface.spacing);
  };
  struct Sum {
    undeformed::LoadedPart<D> part;
    int count = 0, hit = 0;
  };
  auto [mean, count, hit] = undeformed::sum_over_facet<D>([&](auto places) {
    Sum sum;
    for (const undeformed::Barycentric<D>& at : places) {
      Point<D> x = {};
      for (int v = 0; v < D; ++v) {
        for (int a = 0; a < D; ++a) x[a] += at[v] * corner[v][a];
      }
      const auto part =
          undeformed::loaded_part<D>(surface.shape, x, normal, faces, surface.spacing, acts_at);
      ++sum.count;
      sum.hit += part.area != 0 ? 1 : 0;
      sum.part.area += part.area;
      for (int a = 0; a < D; ++a) sum.part.vector[a] += part.vector[a];
    }
    return sum;
  });
  mean.area /= count;
  for (double& component : mean.vector) component /= count;
  return mean;
}

/// A load on the surface around a corner of a facet.
template <int D>
struct LoadAtCorner {
  double size = 0;      ///< area [m^(D-1)]
  Point<D> place = {};  ///< middle of the share (PB.67) times the area [m^D]
  Point<D> area = {};   ///< area vector [m^(D-1)]
  std::array<Point<D>, D> moment =
      {};  ///< [a][b] integral of x_a - X_a by area_b, X the corner [m^D]
};

/// The loads at the corners of a facet on a curved surface, on the parts where `acts_at(place)` is
/// true, (PB.62).
template <int D, class F>
std::array<LoadAtCorner<D>, D> loads_on_parts(const Corners<D>& x,
                                              const undeformed::CurvedFacet<D>& curved,
                                              F&& acts_at) {
  std::array<LoadAtCorner<D>, D> loads;
  for (const undeformed::CurvedPart<D>& part : curved.parts()) {
    if (!acts_at(part.middle)) continue;
    for (int v = 0; v < D; ++v) {
      LoadAtCorner<D>& load = loads[v];
      const double size = part.at[v] * norm<D>(part.area);
      load.size += size;
      for (int b = 0; b < D; ++b) {
        const double area = part.at[v] * part.area[b];
        load.area[b] += area;
        load.place[b] += size * part.middle[b];
        for (int a = 0; a < D; ++a) load.moment[a][b] += (part.middle[a] - x[v][a]) * area;
      }
    }
  }
  return loads;
}

/// Shares out a load at a corner to the nodes that the corner moves with: calls `give(slot, weight,
/// load)`. Moments go to neighbours, too: shares are linear in the place.
template <class T, int D, class F>
void share_out(const Body<T, D>& body, std::int32_t corner, const LoadAtCorner<D>& load, F&& give) {
  for (const undeformed::Share& carrier : shares_of_corner(body, corner)) {
    give(carrier.slot, carrier.weight, load);
  }
  if (load.moment == std::array<Point<D>, D>{}) return;
  const std::int32_t slot = body.surface.node[corner];
  const auto fit = body.surface.fit.find(slot);
  if (fit == body.surface.fit.end()) return;
  for (std::size_t k = 0; k < fit->second.slot.size(); ++k) {
    Point<D> area = {};
    for (int a = 0; a < D; ++a) {
      for (int b = 0; b < D; ++b) area[b] += fit->second.gradient[k][a] * load.moment[a][b];
    }
    LoadAtCorner<D> moved = {norm<D>(area), {}, area, {}};
    for (int b = 0; b < D; ++b) moved.place[b] = moved.size / load.size * load.place[b];
    give(fit->second.slot[k], 1, moved);
    give(slot, -1, moved);
  }
}

/// The shares of nodes in the facets under one load: area vectors by the corners, centres by the
/// loaded parts. Pressures act on all nodes that carry a corner, (PB.51).
template <class T, int D>
class NodesUnderLoad {
 public:
  NodesUnderLoad(const Boundaries<D>& boundaries, int number, const Body<T, D>& body)
      : boundaries_(boundaries),
        number_(number),
        load_(boundaries.pressures[number]),
        body_(body),
        surface_(body.surface),
        loaded_(surface_.facet.size()) {}

  std::map<std::int32_t, PressedNode<D>> operator()() {
    for (std::size_t f = 0; f < surface_.facet.size(); ++f) add(f);
    for (auto& [slot, node] : nodes_) {
      for (double& x : node.middle) x /= around_[slot] > 0 ? around_[slot] : 1;
    }
    return std::move(nodes_);
  }

 private:
  void add(std::size_t number) {
    const std::array<LoadAtCorner<D>, D> loads = loads_on(number);
    for (int v = 0; v < D; ++v) {
      if (loads[v].size == 0) continue;
      share_out(body_, surface_.facet[number][v], loads[v],
                [this](std::int32_t slot, double weight, const LoadAtCorner<D>& load) {
                  give(slot, weight, load);
                });
    }
  }

  /// The loaded part of a facet; both halves of a rectangle ask for those of each other.
  const undeformed::LoadedPart<D>& loaded_part_of(std::size_t number) {
    std::optional<undeformed::LoadedPart<D>>& part = loaded_[number];
    if (!part) {
      const auto [x, vector, normal, whole] = facet_of<D>(surface_, number);
      part =
          loaded_part<D>(boundaries_, load_, surface_, x, normal, faces_of<D>(surface_, x, normal));
    }
    return *part;
  }

  bool is_wholly_loaded(std::size_t number) {
    return dot<D>(loaded_part_of(number).vector, facet_of<D>(surface_, number).normal) >
           whole_facet;
  }

  std::array<LoadAtCorner<D>, D> loads_on(std::size_t number) {
    const auto [x, vector, normal, whole] = facet_of<D>(surface_, number);
    const auto faces = faces_of<D>(surface_, x, normal);
    undeformed::CurvedFacet<D> curved;
    if (surface_.shape != nullptr && !load_.is_traction()) {
      curved = {*surface_.shape, x, surface_.spacing};
    }
    if (!curved.is_flat() && faces.size() == 1) {
      return loads_on_parts<D>(x, curved, [this](const Point<D>& place) {
        return load_.acts_at(place) && !lies_on_a_wall<D>(boundaries_, place, surface_.spacing);
      });
    }
    undeformed::LoadedPart<D> loaded = loaded_part_of(number);
    // So that pressures on a closed surface have no resultant.
    if (!curved.is_flat() && is_wholly_loaded(number)) {
      loaded.vector = curved.area();
      for (double& component : loaded.vector) component /= whole;
    }
    int apex = apex_of_half(surface_, number);
    if (apex >= 0 && !(curved.is_flat() && is_wholly_loaded(number) &&
                       is_wholly_loaded(surface_.other_half[number]))) {
      apex = -1;
    }
    const std::array<double, D> shares = shares_of_corners<D>(apex);
    std::array<LoadAtCorner<D>, D> loads;
    for (int v = 0; v < D; ++v) {
      LoadAtCorner<D>& load = loads[v];
      const Point<D> middle =
          apex < 0 ? undeformed::middle_of_share<D>(x, v) : middle_in_half<D>(x, apex, v);
      load.size = loaded.area * shares[v] * whole;
      for (int a = 0; a < D; ++a) {
        load.area[a] = whole * shares[v] * loaded.vector[a];
        load.place[a] = load.size * middle[a];
      }
    }
    return loads;
  }

  void give(std::int32_t slot, double weight, const LoadAtCorner<D>& load) {
    PressedNode<D>& node = node_in(slot);
    node.size += weight * load.size;
    around_[slot] += std::abs(weight) * load.size;
    for (int a = 0; a < D; ++a) {
      node.area[a] += weight * load.area[a];
      node.middle[a] += std::abs(weight) * load.place[a];
    }
  }

  PressedNode<D>& node_in(std::int32_t slot) {
    return nodes_.insert({slot, {slot, number_, {}, 0, {}}}).first->second;
  }

  static constexpr double whole_facet = 1 - 1e-9;

  const Boundaries<D>& boundaries_;
  int number_;
  const SurfacePressure<D>& load_;
  const Body<T, D>& body_;
  const BodySurface<D>& surface_;
  std::vector<std::optional<undeformed::LoadedPart<D>>> loaded_;  ///< [facet] as far as known
  std::map<std::int32_t, PressedNode<D>> nodes_;
  std::map<std::int32_t, double> around_;  ///< sums of the sizes of shares of both signs [m^(D-1)]
};

}  // namespace pliant::point_based
