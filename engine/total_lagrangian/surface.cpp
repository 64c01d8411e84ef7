#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/lattice/surface_pieces.hpp"
#include "engine/total_lagrangian/setup.hpp"

// The surface of the undeformed body, cut out of its cells simplex by simplex. Corners of facets
// lie on lines between particles, so that the present surface follows from the particles alone.
namespace pliant::total_lagrangian {

namespace {

constexpr int samples = 8;              // to a side of a facet that the rim of a region cuts
constexpr double on_wall = 1e-6;        // [h]
constexpr double smallest_area = 1e-9;  // [h^(D-1)]

template <int D>
using Cube = std::array<SurfaceNode<D>, (1 << D)>;

template <int D>
using Barycentric = std::array<double, D>;

/// A facet of the cell that is being cut; its corners in [0, 1]^D of the cell.
template <int D>
using PlacesInCell = std::array<Point<D>, D>;

/// Of the corners of a cell.
template <int D>
using Weights = std::array<double, (1 << D)>;

template <int D>
Vertex<D> vertex(const Crossing<D>& crossing) {
  Vertex<D> v{static_cast<std::int32_t>(crossing.inside->slot),
              static_cast<std::int32_t>(crossing.outside->slot),
              crossing.fraction(),
              {}};
  Eigen::Map<PlaceVector<D>>(v.start.data()) = crossing.place();
  return v;
}

// Barycentric coordinates of places spread evenly over a facet.
template <int D, class F>
void for_each_sample(F&& f) {
  for (int i = 0; i < samples; ++i) {
    if constexpr (D == 2) {
      const double u = (i + 0.5) / samples;
      f({1 - u, u});
    } else {
      const auto at = [&](double u, double v) { f({1 - u - v, u, v}); };
      for (int j = 0; i + j < samples; ++j) {
        at((i + 1.0 / 3) / samples, (j + 1.0 / 3) / samples);
        if (i + j < samples - 1) at((i + 2.0 / 3) / samples, (j + 2.0 / 3) / samples);
      }
    }
  }
}

// The same of the places at which a rule of quadrature, exact for polynomials of the degree D,
// takes values over a facet, with their weights: Gauss with two points, Dunavant with six.
template <int D, class F>
void for_each_gauss_point(F&& f) {
  if constexpr (D == 2) {
    const double u = 0.5 - std::numbers::sqrt3 / 6;
    f({1 - u, u}, 0.5);
    f({u, 1 - u}, 0.5);
  } else {
    constexpr std::array<double, 2> at = {0.445948490915965, 0.091576213509771};
    constexpr std::array<double, 2> weight = {0.223381589678011, 0.109951743655322};
    for (int i = 0; i < 2; ++i) {
      for (int v = 0; v < 3; ++v) {
        Barycentric<3> place = {at[i], at[i], at[i]};
        place[v] = 1 - 2 * at[i];
        f(place, weight[i]);
      }
    }
  }
}

template <int D>
double length(const Point<D>& x) {
  double square = 0;
  for (const double value : x) square += value * value;
  return std::sqrt(square);
}

template <class T, int D>
class SurfaceMaker {
 public:
  SurfaceMaker(const Boundaries<D>& boundaries, Body<T, D>& body)
      : boundaries_(boundaries),
        body_(body),
        pushes_(body.layout.slots()),
        smallest_(smallest_area * std::pow(body.lattice.spacing, D - 1)) {}

  // Inside corners must be particles; what belongs to an outside corner without one moves with
  // them.
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
    for_each_piece<D>(cube, [&](const SurfacePiece<D>& piece) {
      const Facet<D> made = facet(piece);
      if (length<D>(area_vector(body_, made)) <= smallest_) return;
      body_.facets.push_back(made);
      load(cube, places_in_cell(piece, cell));
    });
  }

  // Which particles the patches push.
  void share_out() {
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

  // All loads on the last facet.
  void load(const Cube<D>& cube, const PlacesInCell<D>& places) {
    const int facet = static_cast<int>(body_.facets.size()) - 1;
    for (int k = 0; k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      int count = 0, hit = 0;
      Weights<D> weights = {};
      for_each_sample<D>([&](const Barycentric<D>& at) {
        ++count;
        const Point<D> x = place(body_.facets[facet], at);
        if (!boundaries_.pressures[k].acts_at(x) || on_a_wall(x)) return;
        ++hit;
        add_weights(places, at, 1, weights);
      });
      if (hit == 0) continue;
      if (hit == count) {
        weights = {};
        for_each_gauss_point<D>([&](const Barycentric<D>& at, double weight) {
          add_weights(places, at, weight, weights);
        });
      }
      push(cube, weights, static_cast<int>(body_.patches.size()));
      body_.patches.push_back({facet, static_cast<double>(hit) / count, k});
    }
  }

  static Point<D> place(const Facet<D>& facet, const Barycentric<D>& at) {
    Point<D> x = {};
    for (int v = 0; v < D; ++v) {
      for (int a = 0; a < D; ++a) x[a] += at[v] * facet.vertex[v].start[a];
    }
    return x;
  }

  // Those of multilinear interpolation in the cell.
  static void add_weights(const PlacesInCell<D>& places, const Barycentric<D>& at, double factor,
                          Weights<D>& weights) {
    Point<D> s = {};
    for (int v = 0; v < D; ++v) {
      for (int a = 0; a < D; ++a) s[a] += at[v] * places[v][a];
    }
    for (int c = 0; c < (1 << D); ++c) {
      double weight = factor;
      for (int a = 0; a < D; ++a) weight *= c >> a & 1 ? s[a] : 1 - s[a];
      weights[c] += weight;
    }
  }

  // (TL.27). Corners that are no particles give what they would bear to the others.
  void push(const Cube<D>& cube, const Weights<D>& weights, int patch) {
    double sum = 0;
    for (int c = 0; c < (1 << D); ++c) {
      if (body_.is_particle(cube[c].slot)) sum += weights[c];
    }
    for (int c = 0; c < (1 << D); ++c) {
      if (!body_.is_particle(cube[c].slot)) continue;
      pushes_[cube[c].slot].push_back({patch, weights[c] / sum});
    }
  }

  const Boundaries<D>& boundaries_;
  Body<T, D>& body_;
  std::vector<std::vector<std::pair<int, double>>> pushes_;  // [slot]
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
  maker.share_out();
}

template void make_surface<double, 2>(const Boundaries<2>&, Body<double, 2>&);
template void make_surface<double, 3>(const Boundaries<3>&, Body<double, 3>&);
template void make_surface<float, 2>(const Boundaries<2>&, Body<float, 2>&);
template void make_surface<float, 3>(const Boundaries<3>&, Body<float, 3>&);

}  // namespace pliant::total_lagrangian
