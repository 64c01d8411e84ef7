#include "engine/remeshed/contact/facing_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/contact/opposing_fit.hpp"

namespace pliant::remeshed {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Cosines between a face and what opposes it: of the mean of a body, which may be that of an edge,
// and of the face of the other body.
constexpr double roughly_opposed = 0.3, opposed = 0.75;
constexpr double beside = 0.7;                    // cosine between a face and its sides
constexpr double of_edge = 0.88, of_face = 0.97;  // sizes of grad phi over that of a clear face
constexpr double sharpness = 4;                   // [1/h], by which the farthest side counts
constexpr double least_part = 0.25;               // of a cell, of a face that ends there
constexpr double least_slope = 0.1;
constexpr double least_weight = 1e-6;

template <int D>
bool normalise(Point<D>& vector) {
  const double square = dot<D>(vector, vector);
  if (!(square > 1e-12)) return false;
  for (double& component : vector) component /= std::sqrt(square);
  return true;
}

template <int D>
Point<D> opposite(Point<D> vector) {
  for (double& component : vector) component = -component;
  return vector;
}

}  // namespace

template <int D>
bool FacingSearch<D>::find(const Side& own, const Side& other, const Point<D>& x,
                           FacingSurfaces<D>& found) {
  gather(other, x, other_);
  Point<D> towards = {}, out, back;
  for (const Particle& q : other_) {
    for (int a = 0; a < D; ++a) towards[a] -= q.weight * q.gradient[a];
  }
  if (!normalise<D>(towards)) return false;
  gather(own, x, own_);
  if (!find_face(own_, towards, roughly_opposed, out)) return false;
  if (!find_face(other_, opposite<D>(out), opposed, back)) return false;
  for (int a = 0; a < D; ++a) found.normal[a] = out[a] - back[a];
  if (!normalise<D>(found.normal)) return false;
  back = opposite<D>(found.normal);
  const double h = own.lattice.spacing, h_other = other.lattice.spacing;
  const double height_of_own = height(own_, found.normal), height_of_other = height(other_, back);
  if (std::isinf(height_of_own) || std::isinf(height_of_other)) return false;
  found.depth = -height_of_own * h;
  found.gap = height_of_own * h + height_of_other * h_other;
  const double of_own = std::min(0.5, -beyond_sides(own_, found.normal));
  const double of_both = std::min(of_own, -beyond_sides(other_, back) * h_other / h);
  found.cover = std::clamp((0.5 + of_both) / std::max(0.5 + of_own, least_part), 0., 1.);
  return true;
}

template <int D>
void FacingSearch<D>::gather(const Side& side, const Point<D>& x, Particles& particles) {
  particles.clear();
  double clear = least_slope;  // the largest size of grad phi
  const SurfaceSamples<D>& surface = side.surface;
  const Point<D> at = place<D>(x, side.lattice);
  surface.cells.any_near(at, [&](const auto& site, const Point<D>& shift) {
    if (surface.record[site.label] < 0) return false;
    Particle q;
    for (int a = 0; a < D; ++a) q.offset[a] = site.position[a] + shift[a] - at[a];
    const double fraction = dot<D>(q.offset, q.offset) / (contact_fit_radius * contact_fit_radius);
    if (fraction >= 1) return false;
    q.weight = (1 - fraction) * (1 - fraction);
    q.level_set = surface.level_set[site.label];
    q.gradient = q.normal = surface.gradient[site.label];
    q.clarity = std::sqrt(dot<D>(q.gradient, q.gradient));
    for (double& component : q.normal) component /= std::max(q.clarity, least_slope);
    clear = std::max(clear, q.clarity);
    particles.push_back(q);
    return false;
  });
  // Where the body is stretched, grad phi is less than 1 on its faces too.
  clear = std::min(clear, 1.);
  for (Particle& q : particles) {
    q.clarity = std::clamp((q.clarity / clear - of_edge) / (of_face - of_edge), 0., 1.);
  }
}

/// The weight of a particle as one of the face with this normal.
template <int D>
double FacingSearch<D>::share(const Particle& particle, const Point<D>& normal, double least) {
  return particle.weight * particle.clarity * std::max(0., dot<D>(particle.normal, normal) - least);
}

template <int D>
bool FacingSearch<D>::find_face(const Particles& particles, const Point<D>& towards, double least,
                                Point<D>& normal) {
  normal = {};
  for (const Particle& q : particles) {
    const double weight = share(q, towards, least);
    for (int a = 0; a < D; ++a) normal[a] += weight * q.gradient[a];
  }
  return normalise<D>(normal);
}

// phi at x from its value and slope at each particle. The slope is the mean of that at the particle
// and that at x, so that the curvature of the face has no effect.
template <int D>
double FacingSearch<D>::height(const Particles& particles, const Point<D>& normal) {
  double weight = 0, sum = 0;
  Point<D> slope = {};
  for (const Particle& q : particles) {
    const double part = share(q, normal, opposed);
    weight += part;
    for (int a = 0; a < D; ++a) slope[a] += part * q.gradient[a];
  }
  if (!(weight > least_weight)) return infinity;
  for (double& component : slope) component /= weight;
  for (const Particle& q : particles) {
    const double fall = (dot<D>(q.gradient, q.offset) + dot<D>(slope, q.offset)) / 2;
    sum += share(q, normal, opposed) * (q.level_set - fall);
  }
  return sum / weight;
}

// How far x is beyond the sides of the face [h]. Where several are near, the largest of the
// distances counts most.
template <int D>
double FacingSearch<D>::beyond_sides(const Particles& particles, const Point<D>& normal) {
  constexpr double farthest = 4;
  double weight = 0, sum = 0;
  for (const Particle& q : particles) {
    if (q.clarity == 0 || std::abs(dot<D>(q.normal, normal)) > beside) continue;
    const double distance = q.level_set - dot<D>(q.gradient, q.offset);
    const double part = q.weight * q.clarity * std::exp(sharpness * std::min(distance, farthest));
    weight += part;
    sum += part * distance;
  }
  return weight > 0 ? sum / weight : -infinity;
}

template class FacingSearch<2>;
template class FacingSearch<3>;

}  // namespace pliant::remeshed
