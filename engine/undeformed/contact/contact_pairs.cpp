#include "engine/undeformed/contact/contact_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/undeformed/contact/carried_points.hpp"
#include "engine/undeformed/contact/facet_point.hpp"
#include "engine/undeformed/contact/held_back.hpp"

namespace pliant::undeformed {

namespace {

constexpr double least_meeting_compliance =
    1e-3;  // along the normal, relative to that without walls

double coefficient_of(const ContactCase& contact) {
  switch (contact.law) {
    case ContactLaw::frictionless:
      return 0;
    case ContactLaw::coulomb:
      return contact.friction;
    case ContactLaw::no_slip:
    case ContactLaw::tied:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

template <class T, int D>
void ContactPairs<T, D>::clear() {
  pairs_.clear();
  friction_.clear();
  shares_.clear();
}

template <class T, int D>
void ContactPairs<T, D>::add(const ContactSide<T, D>& side, std::span<const Penetration<D>> touches,
                             const ContactTimes& times) {
  for (const Penetration<D>& touch : touches) {
    ContactPair<T, D> pair{&side, touch, shares_.size(), 0};
    const std::array<Point<D>, D> c = side.facets.places(touch.facet);
    pair.touch.weight = nearest_weights(c, face_before(pair, c, times.drift));
    side.facets.append_shares(touch.facet, pair.touch.weight, shares_);
    pair.end_share = shares_.size();
    prepare(pair, times);
    if (pair.compliance >= least_meeting_compliance * pair.largest_compliance) {
      pairs_.push_back(pair);
      friction_.push_back({{}, {}, slip(pair)});
    } else {
      shares_.resize(pair.first_share);
    }
  }
}

// The corner pushes the point that it faced when the forces of the step acted. Without slip this is
// the touched point; with slip, the impulses then exert no torque.
template <class T, int D>
Point<D> ContactPairs<T, D>::face_before(const ContactPair<T, D>& pair,
                                         const std::array<Point<D>, D>& c, double drift) const {
  const Penetration<D>& touch = pair.touch;
  const MovingSurface<T, D>& facets = pair.side->facets;
  Point<D> w = pair.side->corners.motion(corner_shares(pair)).velocity;
  for (int v = 0; v < D; ++v) {
    if (touch.weight[v] == 0) continue;
    const std::int32_t corner = facets.facet(touch.facet)[v];
    const Point<D> u = facets.motion(facets.shares(corner)).velocity;
    for (int a = 0; a < D; ++a) w[a] -= touch.weight[v] * u[a];
  }
  const double speed = dot<D>(w, touch.normal);
  Point<D> before;
  for (int a = 0; a < D; ++a) {
    before[a] = -drift * (w[a] - speed * touch.normal[a]);
    for (int v = 0; v < D; ++v) before[a] += touch.weight[v] * c[v][a];
  }
  return before;
}

template <class T, int D>
void ContactPairs<T, D>::prepare(ContactPair<T, D>& pair, const ContactTimes& times) {
  const ContactSide<T, D>& side = *pair.side;
  const Point<D>& n = pair.touch.normal;
  pair.largest_compliance = free_compliance(side.corners, corner_shares(pair)) +
                            free_compliance(side.facets, facet_shares(pair));
  pair.compliance = pair.largest_compliance;
  if (side.corners.is_held() || side.facets.is_held()) {
    pair.compliance = compliance<D>(side.corners, corner_shares(pair), n) +
                      compliance<D>(side.facets, facet_shares(pair), n);
  }
  // Velocities of the middle of a step may close a gap that was open at its start.
  if (times.drift != times.length) return;
  const double speed = dot<D>(slip(pair), n);
  pair.approach = std::max(pair.touch.gap / times.length - speed, 0.);
}

template <class T, int D>
ContactMotion<D> ContactPairs<T, D>::relative(const ContactPair<T, D>& pair) const {
  const ContactMotion<D> corner = pair.side->corners.motion(corner_shares(pair));
  const ContactMotion<D> point = pair.side->facets.motion(facet_shares(pair));
  return {difference<D>(corner.velocity, point.velocity), difference<D>(corner.shift, point.shift)};
}

template <class T, int D>
double ContactPairs<T, D>::sweep(std::span<const ContactCase> contacts, const ContactTimes& times,
                                 double relaxation) {
  const double drift = times.drift;
  double most = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactCase& contact = contacts[pairs_[k].side->contact];
    most = std::max(most, push(pairs_[k], friction_[k], contact, drift, relaxation));
  }
  return most;
}

// Summed impulses never pull, and friction is limited by the summed normal impulse: a sweep
// corrects what an earlier one has pushed too far.
template <class T, int D>
double ContactPairs<T, D>::push(ContactPair<T, D>& pair, PairFriction<D>& friction,
                                const ContactCase& law, double drift, double relaxation) {
  const Point<D>& n = pair.touch.normal;
  const ContactMotion<D> motion = relative(pair);
  const double gap = pair.touch.gap + dot<D>(motion.shift, n), speed = dot<D>(motion.velocity, n);
  const double impulse_now =
      std::max(-relaxation * (speed + pair.approach) / pair.compliance, -pair.normal_impulse);
  const double shift_now = std::max(-relaxation * gap / pair.compliance, -pair.normal_shift);
  pair.normal_impulse += impulse_now;
  pair.normal_shift += shift_now;
  Point<D> impulse, shift;
  for (int a = 0; a < D; ++a) impulse[a] = impulse_now * n[a], shift[a] = shift_now * n[a];
  if (const double coefficient = coefficient_of(law); coefficient > 0) {
    const PairFriction<D> before = friction;
    hold_back(pair, motion, coefficient, drift, relaxation, friction);
    for (int a = 0; a < D; ++a) {
      const double along = friction.impulse[a] - before.impulse[a];
      impulse[a] += along;
      shift[a] += drift * along + friction.shift[a] - before.shift[a];
    }
  }
  if (impulse == Point<D>{} && shift == Point<D>{}) return 0;
  const double change = pair.compliance * std::sqrt(dot<D>(impulse, impulse));
  push_point<D>(pair.side->corners, corner_shares(pair), impulse, shift);
  for (int a = 0; a < D; ++a) impulse[a] = -impulse[a], shift[a] = -shift[a];
  push_point<D>(pair.side->facets, facet_shares(pair), impulse, shift);
  return change;
}

template <class T, int D>
void ContactPairs<T, D>::hold_back(const ContactPair<T, D>& pair, const ContactMotion<D>& motion,
                                   double coefficient, double drift, double relaxation,
                                   PairFriction<D>& friction) {
  const Point<D>& n = pair.touch.normal;
  const double compliance = pair.largest_compliance / relaxation;
  Point<D> stray;
  for (int a = 0; a < D; ++a) {
    stray[a] = motion.shift[a] - drift * (motion.velocity[a] - friction.slip[a]);
  }
  friction.impulse = held_back<D>(friction.impulse, motion.velocity, n, compliance, coefficient,
                                  pair.normal_impulse);
  friction.shift =
      held_back<D>(friction.shift, stray, n, compliance, coefficient, pair.normal_shift);
}

template class ContactPairs<double, 2>;
template class ContactPairs<double, 3>;
template class ContactPairs<float, 2>;
template class ContactPairs<float, 3>;

}  // namespace pliant::undeformed
