#include <algorithm>
#include <cmath>

#include "engine/lattice/surface_pieces.hpp"
#include "engine/method/decompositions.hpp"
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
Vertex<D> vertex(const Crossing<D>& crossing) {
  Vertex<D> v{static_cast<std::int32_t>(crossing.inside->slot),
              static_cast<std::int32_t>(crossing.outside->slot),
              crossing.fraction(),
              {}};
  Eigen::Map<PlaceVector<D>>(v.start.data()) = crossing.place();
  return v;
}

// Places spread evenly over a facet.
template <int D, class F>
void for_each_sample(const Facet<D>& facet, F&& f) {
  const auto at = [&](double u, double v) {
    Point<D> x;
    for (int a = 0; a < D; ++a) {
      const auto& corner = facet.vertex;
      x[a] = corner[0].start[a] + u * (corner[1].start[a] - corner[0].start[a]);
      if (D == 3) x[a] += v * (corner[D - 1].start[a] - corner[0].start[a]);
    }
    f(x);
  };
  for (int i = 0; i < samples; ++i) {
    if (D == 2) {
      at((i + 0.5) / samples, 0);
      continue;
    }
    for (int j = 0; i + j < samples; ++j) {
      at((i + 1.0 / 3) / samples, (j + 1.0 / 3) / samples);
      if (i + j < samples - 1) at((i + 2.0 / 3) / samples, (j + 2.0 / 3) / samples);
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
    const int first = static_cast<int>(body_.facets.size());
    for_each_piece<D>(cube, [&](const SurfacePiece<D>& piece) {
      const Facet<D> made = facet(piece);
      if (length<D>(area_vector(body_, made)) > smallest_) body_.facets.push_back(made);
    });
    const int end = static_cast<int>(body_.facets.size());
    for (int k = 0; first < end && k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      load(cube, first, end, k);
    }
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

  void load(const Cube<D>& cube, int first_facet, int end_facet, int pressure) {
    const int first_load = static_cast<int>(body_.loads.size());
    double loaded = 0;
    Point<D> middle = {};
    for (int f = first_facet; f < end_facet; ++f) {
      int count = 0, hit = 0;
      Point<D> sum = {};
      for_each_sample(body_.facets[f], [&](const Point<D>& x) {
        ++count;
        if (!boundaries_.pressures[pressure].acts_at(x) || on_a_wall(x)) return;
        ++hit;
        for (int a = 0; a < D; ++a) sum[a] += x[a];
      });
      if (hit == 0) continue;
      const double share = static_cast<double>(hit) / count;
      const double area = length<D>(area_vector(body_, body_.facets[f])) * share;
      body_.loads.push_back({f, share});
      loaded += area;
      for (int a = 0; a < D; ++a) middle[a] += area * sum[a] / hit;
    }
    const int loads = static_cast<int>(body_.loads.size()) - first_load;
    if (loads == 0) return;
    for (double& x : middle) x /= loaded;
    push(cube, middle, static_cast<int>(body_.patches.size()));
    body_.patches.push_back({first_load, loads, pressure});
  }

  // (TL.7): on the corners inside, as those outside may weigh next to nothing and would fly off; of
  // all weights that put the force in the middle of the loaded area, the smallest. They are linear
  // in the corners' places: weights of another kind would feed the hourglass modes.
  void push(const Cube<D>& cube, const Point<D>& middle, int patch) {
    std::vector<std::pair<std::int64_t, PlaceVector<D>>> corners;
    PlaceVector<D> mean = PlaceVector<D>::Zero();
    for (const SurfaceNode<D>& corner : cube) {
      if (corner.phi >= 0) continue;
      corners.emplace_back(corner.slot, corner.place);
      mean += corner.place;
    }
    mean /= static_cast<double>(corners.size());
    Eigen::Matrix<double, D, D> spread = Eigen::Matrix<double, D, D>::Zero();
    for (const auto& [slot, x] : corners) spread += (x - mean) * (x - mean).transpose();
    const PlaceVector<D> lever =
        pseudo_inverse<D>(spread) * (Eigen::Map<const PlaceVector<D>>(middle.data()) - mean);
    for (const auto& [slot, x] : corners) {
      const double weight = 1 / static_cast<double>(corners.size()) + (x - mean).dot(lever);
      pushes_[slot].push_back({patch, weight});
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
