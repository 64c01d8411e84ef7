#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/total_lagrangian/setup.hpp"

// The surface of the undeformed body, cut out of its cells simplex by simplex. Corners of facets
// lie on lines between particles, so that the present surface follows from the particles alone.
namespace pliant::total_lagrangian {

namespace {

constexpr int samples = 8;              // to a side of a facet that the rim of a region cuts
constexpr double on_wall = 1e-6;        // [h]
constexpr double smallest_area = 1e-9;  // [h^(D-1)]

template <int D>
struct Corner {
  std::int64_t slot;
  Point<D> place;
  double phi;
};
template <int D>
using Cube = std::array<Corner<D>, (1 << D)>;
template <int D>
using Simplex = std::array<Corner<D>, D + 1>;

/// A corner of a piece of surface: between the inside and the outside corner of a simplex.
template <int D>
struct Crossing {
  const Corner<D>*inside, *outside;
};
template <int D>
using Piece = std::array<Crossing<D>, D>;

// Where phi changes sign between one corner and all others the surface is one piece; in space,
// where it changes sign between two and two, it is a quadrilateral.
template <int D, class F>
void for_each_piece(Simplex<D> simplex, F&& f) {
  const auto is_inside = [](const Corner<D>& corner) { return corner.phi < 0; };
  const auto middle = std::stable_partition(simplex.begin(), simplex.end(), is_inside);
  const auto inside = middle - simplex.begin();
  const auto crossing = [&](int i, int o) { return Crossing<D>{&simplex[i], &simplex[o]}; };
  if (inside == 0 || inside == D + 1) return;
  if constexpr (D == 3) {
    if (inside == 2) {
      f(Piece<3>{crossing(0, 2), crossing(0, 3), crossing(1, 3)});
      f(Piece<3>{crossing(0, 2), crossing(1, 3), crossing(1, 2)});
      return;
    }
  }
  Piece<D> piece;
  for (int i = 0; i < D; ++i) piece[i] = inside == 1 ? crossing(0, i + 1) : crossing(i, D);
  f(piece);
}

// The cell falls into simplices along its diagonal, one for each way to walk it edge by edge.
template <int D, class F>
void for_each_piece(const Cube<D>& cube, F&& f) {
  std::array<int, D> axes;
  std::iota(axes.begin(), axes.end(), 0);
  do {
    Simplex<D> simplex = {cube[0]};
    for (int i = 0, corner = 0; i < D; ++i) simplex[i + 1] = cube[corner |= 1 << axes[i]];
    for_each_piece<D>(simplex, f);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

template <int D>
Vertex<D> vertex(const Crossing<D>& crossing) {
  Vertex<D> v{static_cast<std::int32_t>(crossing.inside->slot),
              static_cast<std::int32_t>(crossing.outside->slot),
              crossing.inside->phi / (crossing.inside->phi - crossing.outside->phi),
              {}};
  for (int a = 0; a < D; ++a) {
    const double from = crossing.inside->place[a];
    v.start[a] = from + v.along * (crossing.outside->place[a] - from);
  }
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
      if (slots[c] < 0) return;
      cube[c] = {slots[c], {}, static_cast<double>(body_.level_set[slots[c]])};
      if (cube[c].phi < 0 && !body_.is_particle(slots[c])) return;
      for (int a = 0; a < D; ++a) cube[c].place[a] = body_.lattice.node(a, cell[a] + (c >> a & 1));
    }
    const int first = static_cast<int>(body_.facets.size());
    for_each_piece<D>(cube, [&](const Piece<D>& piece) {
      const Facet<D> facet = oriented(piece);
      if (length<D>(area_vector(body_, facet)) > smallest_) body_.facets.push_back(facet);
    });
    const int end = static_cast<int>(body_.facets.size());
    for (int k = 0; first < end && k < static_cast<int>(boundaries_.pressures.size()); ++k) {
      load(cube, first, end, k);
    }
  }

  // Which particles the patches push.
  void share_out() {
    body_.pushes.assign(body_.layout.blocks().size(), {});
    for (std::size_t b = 0; b < body_.pushes.size(); ++b) {
      Pushes& to = body_.pushes[b];
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
  Facet<D> oriented(const Piece<D>& piece) const {
    Facet<D> facet;
    Point<D> centre = {}, out = {};
    for (int v = 0; v < D; ++v) {
      facet.vertex[v] = vertex(piece[v]);
      if (!body_.is_particle(facet.vertex[v].second))
        facet.vertex[v].second = facet.vertex[v].first;
      for (int a = 0; a < D; ++a) {
        centre[a] += facet.vertex[v].start[a] / D;
        out[a] += piece[v].outside->place[a] - piece[v].inside->place[a];
      }
    }
    const Point<D> normal = area_vector(body_, facet);
    double along = 0;
    for (int a = 0; a < D; ++a) along += normal[a] * out[a];
    if (along < 0) std::swap(facet.vertex[0], facet.vertex[1]);
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
    using Vector = Eigen::Matrix<double, D, 1>;
    std::vector<std::pair<std::int64_t, Vector>> corners;
    Vector mean = Vector::Zero();
    for (const Corner<D>& corner : cube) {
      if (corner.phi >= 0) continue;
      corners.emplace_back(corner.slot, Eigen::Map<const Vector>(corner.place.data()));
      mean += corners.back().second;
    }
    mean /= static_cast<double>(corners.size());
    Eigen::Matrix<double, D, D> spread = Eigen::Matrix<double, D, D>::Zero();
    for (const auto& [slot, x] : corners) spread += (x - mean) * (x - mean).transpose();
    const Vector lever = spread.completeOrthogonalDecomposition().solve(
        Eigen::Map<const Vector>(middle.data()) - mean);
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

}  // namespace pliant::total_lagrangian
