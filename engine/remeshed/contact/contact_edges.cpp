#include "engine/remeshed/contact/contact_edges.hpp"

#include <cmath>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"

namespace pliant::remeshed {

namespace {

constexpr double edge_height = 0.3;  // [h], an edge higher above the wall does not touch it
constexpr double edge_reach = 2.6;   // [h], of fits, (RP.43)
// A slot that is covered less follows the next one inside: phi rounds edges, so that near them the
// surface seems to be above the wall.
constexpr double covered = 0.95;

/// A vector without its component along the unit vector n.
template <int D>
Point<D> along_plane(Point<D> vector, const Point<D>& n) {
  const double across = dot<D>(vector, n);
  for (int a = 0; a < D; ++a) vector[a] -= across * n[a];
  return vector;
}

}  // namespace

template <class T, int D>
std::int32_t ContactEdges<T, D>::beyond(std::int64_t slot, const Point<D>& x, int wall) const {
  const Wall<D>& of = boundaries_.walls[wall];
  const double h = body_.lattice.spacing, depth = -of.distance(x);
  const Point<D> n = of.normal(x);
  Point<D> offset = {}, surface = x, edge = x;
  if (!level_set_.closest_point(slot, offset)) return no_edge;
  for (int a = 0; a < D; ++a) {
    surface[a] += offset[a];
    edge[a] += depth * n[a];
  }
  const WallCover<T, D> cover(body_.lattice, level_set_);
  if (of.distance(surface) > edge_height * h || cover.share(edge, n) >= covered) return no_edge;
  const double distance = cover.side(edge, n);
  const Point<D> outward = cover.outward(edge, n);
  if (distance > edge_reach) return no_edge;
  for (int a = 0; a < D; ++a) edge[a] -= distance * h * outward[a];
  return under(edge, outward, wall);
}

template <class T, int D>
std::int32_t ContactEdges<T, D>::beside(const Point<D>& x, const Point<D>& foot,
                                        Point<D>& up) const {
  const auto [wall, height] = boundaries_.nearest_contact(foot);
  if (wall < 0 || height > edge_reach * body_.lattice.spacing) return no_edge;
  const Point<D> n = boundaries_.walls[wall].normal(foot), inward = difference<D>(foot, x);
  const double square = dot<D>(inward, inward), towards = dot<D>(inward, n);
  if (square == 0 || towards > WallCover<T, D>::facing * std::sqrt(square)) return no_edge;
  const Point<D> lateral = along_plane<D>(inward, n);
  Point<D> below = foot;
  for (int a = 0; a < D; ++a) below[a] -= height * n[a];
  const double length = std::sqrt(dot<D>(lateral, lateral));
  if (length == 0) return no_edge;
  const double slope = WallCover<T, D>(body_.lattice, level_set_).slope(below, n);
  for (int a = 0; a < D; ++a) {
    up[a] = std::sqrt(1 - slope * slope) * n[a] + slope * lateral[a] / length;
  }
  Point<D> outward;
  for (int a = 0; a < D; ++a) outward[a] = -lateral[a] / length;
  return under(foot, outward, wall);
}

// The nearest slot inside whose cell the body covers, in the row nearest to the wall.
template <class T, int D>
std::int32_t ContactEdges<T, D>::under(const Point<D>& edge, const Point<D>& outward,
                                       int wall) const {
  const double h = body_.lattice.spacing;
  const Wall<D>& of = boundaries_.walls[wall];
  const Point<D> n = of.normal(edge);
  const double height = of.distance(edge);
  const WallCover<T, D> cover(body_.lattice, level_set_);
  for (const double inside : {1., 1.5, 2.}) {
    for (const double depth : {0.5, 1., 1.5}) {
      Cell<D> cell;
      for (int a = 0; a < D; ++a) {
        const double at = edge[a] - inside * h * outward[a] - (height + depth * h) * n[a];
        cell[a] = body_.lattice.cell(a, at);
      }
      const std::int64_t slot = population_.layout.slot(body_.lattice.wrapped(cell));
      if (slot < 0 || population_.kind[slot] != Kind::free_ghost) continue;
      Point<D> x = body_.lattice.node(cell);
      const double beyond = of.distance(x);
      for (int a = 0; a < D; ++a) x[a] -= beyond * n[a];
      if (beyond < 0 && cover.share(x, n) >= covered) return static_cast<std::int32_t>(slot);
    }
  }
  return no_edge;
}

template <class T, int D>
void follow_edges(Body<T, D>& body, int block) {
  BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  for (const std::int32_t g : ghosts.contact) {
    if (ghosts.edge[g] == no_edge) continue;
    const bool is_held = body.population.kind[ghosts.edge[g]] == Kind::wall_ghost;
    ghosts.active[g] = is_held;
    ghosts.active[g - 1] = !is_held;
  }
}

template <class T, int D>
kernels::SurfaceLoad<T, D> load_beside_edge(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                            std::size_t g, const Point<D>& x,
                                            const BoundaryValues<D>& values) {
  const Point<D>& up = ghosts.normal[g];
  Point<D> normal = {}, force = {};
  for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
    const std::int64_t record = kernels::record_of(ghosts.pairs[k]);
    const kernels::RecordSum<T, D> particle{body.records.get() + record * kernels::record_width<D>};
    const double c = fit_coefficient<T, D>(ghosts, g, k, ghosts.terms[g].linear);
    Point<D> gradient;
    for (int a = 0; a < D; ++a) gradient[a] = particle.level_set_gradient(a);
    if (dot<D>(gradient, up) < 0) gradient = along_plane<D>(gradient, up);
    for (int a = 0; a < D; ++a) normal[a] += c * gradient[a];
    const std::int8_t own = ghosts.pressure[g];
    const std::int8_t load = own == several_loads ? body.population.load[record] : own;
    if (load < 0) continue;
    const double area = std::sqrt(dot<D>(gradient, gradient));
    const double share = body.population.loaded_share[record];
    const Point<D> traction = values.traction_at(load, x);
    const double pressure = values.pressure_at(load, x);
    for (int a = 0; a < D; ++a) {
      force[a] += share * c * (traction[a] * area - pressure * gradient[a]);
    }
  }
  const double square = dot<D>(normal, normal);
  kernels::SurfaceLoad<T, D> load = {};
  if (square < 1e-12) return load;
  const double across = dot<D>(force, normal) / square, length = std::sqrt(square);
  for (int a = 0; a < D; ++a) {
    load.n[a] = static_cast<T>(normal[a] / length);
    load.shear[a] = static_cast<T>((force[a] - across * normal[a]) / length);
  }
  load.normal = static_cast<T>(across);
  return load;
}

template class ContactEdges<double, 2>;
template class ContactEdges<double, 3>;
template class ContactEdges<float, 2>;
template class ContactEdges<float, 3>;

template void follow_edges<double, 2>(Body<double, 2>&, int);
template void follow_edges<double, 3>(Body<double, 3>&, int);
template void follow_edges<float, 2>(Body<float, 2>&, int);
template void follow_edges<float, 3>(Body<float, 3>&, int);
template kernels::SurfaceLoad<double, 2> load_beside_edge<double, 2>(const Body<double, 2>&,
                                                                     const BlockGhosts<double, 2>&,
                                                                     std::size_t, const Point<2>&,
                                                                     const BoundaryValues<2>&);
template kernels::SurfaceLoad<double, 3> load_beside_edge<double, 3>(const Body<double, 3>&,
                                                                     const BlockGhosts<double, 3>&,
                                                                     std::size_t, const Point<3>&,
                                                                     const BoundaryValues<3>&);
template kernels::SurfaceLoad<float, 2> load_beside_edge<float, 2>(const Body<float, 2>&,
                                                                   const BlockGhosts<float, 2>&,
                                                                   std::size_t, const Point<2>&,
                                                                   const BoundaryValues<2>&);
template kernels::SurfaceLoad<float, 3> load_beside_edge<float, 3>(const Body<float, 3>&,
                                                                   const BlockGhosts<float, 3>&,
                                                                   std::size_t, const Point<3>&,
                                                                   const BoundaryValues<3>&);

}  // namespace pliant::remeshed
