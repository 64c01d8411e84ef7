#include "engine/point_based/blades/puncture.hpp"

#include <algorithm>
#include <cmath>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/cutting/subdivide.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"
#include "engine/undeformed/contact/facet_point.hpp"
#include "kernels/material.hpp"

namespace pliant::point_based {

namespace {

constexpr int puncture_sweeps = 4;       // Gauss-Seidel sweeps, since facets share nodes
constexpr double crossings_of_mean = 3;  // averaging time: a wave crosses so many H in it
constexpr double point_distance = 0.5;   // along the edge [H]
constexpr double deepest_dent = 1;  // largest depth of a point behind the facet that it pushes [H]
constexpr double same_distance = 1 + 1e-9;

}  // namespace

template <class T, int D>
Puncture<T, D>::Puncture(const Body<T, D>& body, double threshold)
    : threshold_(threshold),
      time_constant_(crossings_of_mean * body.resolution /
                     kernels::wave_speed_at_rest(body.source->material)),
      size_(body.resolution),
      held_(undeformed::held_directions(body)) {}

template <class T, int D>
auto Puncture<T, D>::points_of(const Edge& edge) const -> Edge {
  Edge points = {edge.front()};
  for (std::size_t k = 0; k + 1 < edge.size(); ++k) {
    const Point<D> along = difference<D>(edge[k + 1], edge[k]);
    const int count =
        1 + static_cast<int>(std::sqrt(dot<D>(along, along)) / (point_distance * size_));
    for (int i = 1; i <= count; ++i) {
      points.push_back(between<D>(edge[k], edge[k + 1], static_cast<double>(i) / count));
    }
  }
  return points;
}

template <class T, int D>
std::array<Point<D>, D> Puncture<T, D>::corners(const Body<T, D>& body, std::int32_t facet) const {
  std::array<Point<D>, D> places;
  for (int v = 0; v < D; ++v) {
    const std::int32_t corner = body.surface.facet[facet][v];
    for (int a = 0; a < D; ++a) {
      places[v][a] =
          body.surface.start[corner][a] + body.displacement[a][body.surface.node[corner]];
    }
  }
  return places;
}

template <class T, int D>
std::vector<std::int32_t> Puncture<T, D>::facets_near(const Body<T, D>& body,
                                                      const Edge& points) const {
  Box<D> edge;
  for (const Point<D>& x : points) edge.grow(x);
  std::vector<std::int32_t> facets;
  for (std::size_t f = 0; f < body.surface.facet.size(); ++f) {
    Box<D> box;
    for (const Point<D>& x : corners(body, static_cast<std::int32_t>(f))) box.grow(x);
    const double reach = deepest_dent * size_;
    if (squared_gap(box, edge) <= reach * reach) facets.push_back(static_cast<std::int32_t>(f));
  }
  return facets;
}

// Near an edge of the surface, several facets are equally near. The one that faces the point most
// tells on which side the point is.
template <class T, int D>
auto Puncture<T, D>::touch(const Body<T, D>& body, const std::vector<std::int32_t>& facets,
                           const Point<D>& x) const -> std::optional<Touch> {
  std::optional<Touch> nearest;
  double least = deepest_dent * size_ * deepest_dent * size_;
  for (const std::int32_t facet : facets) {
    const std::array<Point<D>, D> places = corners(body, facet);
    const auto weight = undeformed::nearest_weights(places, x);
    const Point<D> away = undeformed::way_from<D>(places, weight, x);
    const double square = dot<D>(away, away);
    if (square > same_distance * least) continue;
    Touch found{{}, undeformed::area_vector<D>(places), 0};
    if (undeformed::normalise<D>(found.normal) == 0) continue;
    found.gap = dot<D>(found.normal, away);
    const bool is_as_near = nearest && square * same_distance >= least;
    if (is_as_near && std::abs(found.gap) <= std::abs(nearest->gap)) continue;
    for (int v = 0; v < D; ++v) {
      const std::int32_t slot = body.surface.node[body.surface.facet[facet][v]];
      const auto known = std::find_if(found.shares.begin(), found.shares.end(),
                                      [slot](const auto& share) { return share.slot == slot; });
      if (known == found.shares.end()) {
        found.shares.push_back({slot, weight[v]});
      } else {
        known->weight += weight[v];
      }
    }
    least = std::min(least, square);
    nearest = std::move(found);
  }
  if (nearest && nearest->gap >= 0) nearest.reset();
  return nearest;
}

template <class T, int D>
BladeLoad<D> Puncture<T, D>::push(Body<T, D>& body, const Edge& before, const Edge& now,
                                  const ContactStep& step) {
  const Edge points = points_of(now), from = points_of(before);
  const std::vector<std::int32_t> facets = facets_near(body, points);
  const bool in_middle = step.drift == step.length;
  undeformed::BodyCarriers<T, D> carriers(body, body.displacement, held_);
  BladeLoad<D> sum;
  for (int sweep = 0; sweep < puncture_sweeps && !facets.empty(); ++sweep) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto met = touch(body, facets, points[k]);
      if (!met) continue;
      const Point<D>& n = met->normal;
      const double soft = undeformed::compliance<D>(carriers, met->shares, n);
      if (soft == 0) continue;
      Point<D> velocity = difference<D>(points[k], from[std::min(k, from.size() - 1)]);
      for (double& component : velocity) component /= step.length;
      const Point<D> of_body = undeformed::carried<T, D>(body.velocity, met->shares);
      const double approach = dot<D>(n, of_body) - dot<D>(n, velocity);
      const double pushed = in_middle ? -met->gap / step.length : std::max(approach, 0.);
      Point<D> impulse, moved;
      for (int a = 0; a < D; ++a) {
        impulse[a] = -pushed / soft * n[a];
        moved[a] = met->gap / soft * n[a];
        const double force = step.inertia * impulse[a] / step.length;
        sum.force[a] += force;
        sum.power += force * velocity[a];
      }
      undeformed::push_point<D>(carriers, met->shares, impulse, moved);
    }
  }
  const double kept = std::exp(-step.length / time_constant_);
  mean_force_ = kept * mean_force_ + (1 - kept) * std::sqrt(dot<D>(sum.force, sum.force));
  return sum;
}

template class Puncture<double, 2>;
template class Puncture<double, 3>;
template class Puncture<float, 2>;
template class Puncture<float, 3>;

}  // namespace pliant::point_based
