#include "engine/undeformed/contact/meetings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/undeformed/contact/carried_points.hpp"
#include "engine/undeformed/contact/facet_point.hpp"

namespace pliant::undeformed {

namespace {

constexpr double least_meeting_compliance =
    1e-3;  // along the normal, relative to that without walls

}  // namespace

template <class T, int D>
void Meetings<T, D>::clear() {
  meetings_.clear();
  shares_.clear();
}

template <class T, int D>
void Meetings<T, D>::add(const ContactSide<T, D>& side, std::span<const Penetration<D>> touches,
                         const ContactTimes& times) {
  for (const Penetration<D>& touch : touches) {
    Meeting<T, D> meeting{&side, touch, shares_.size(), 0};
    const std::array<Point<D>, D> c = side.facets.places(touch.facet);
    meeting.touch.weight = nearest_weights(c, face_before(meeting, c, times.drift));
    side.facets.append_shares(touch.facet, meeting.touch.weight, shares_);
    meeting.end_share = shares_.size();
    meet(meeting, times);
    if (meeting.compliance >= least_meeting_compliance * meeting.largest_compliance) {
      meetings_.push_back(meeting);
    } else {
      shares_.resize(meeting.first_share);
    }
  }
}

// The corner pushes the point that it faced when the forces of the step acted. Without slip this is
// the touched point; with slip, the impulses then exert no torque.
template <class T, int D>
Point<D> Meetings<T, D>::face_before(const Meeting<T, D>& meeting, const std::array<Point<D>, D>& c,
                                     double drift) const {
  const Penetration<D>& touch = meeting.touch;
  const MovingSurface<T, D>& facets = meeting.side->facets;
  Point<D> w = meeting.side->corners.motion(corner_shares(meeting)).velocity;
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
void Meetings<T, D>::meet(Meeting<T, D>& meeting, const ContactTimes& times) {
  const ContactSide<T, D>& side = *meeting.side;
  const Point<D>& n = meeting.touch.normal;
  meeting.largest_compliance = free_compliance(side.corners, corner_shares(meeting)) +
                               free_compliance(side.facets, facet_shares(meeting));
  meeting.compliance = meeting.largest_compliance;
  if (side.corners.is_held() || side.facets.is_held()) {
    meeting.compliance = compliance<D>(side.corners, corner_shares(meeting), n) +
                         compliance<D>(side.facets, facet_shares(meeting), n);
  }
  // Velocities of the middle of a step may close a gap that was open at its start.
  if (times.drift != times.length) return;
  const double speed = dot<D>(slip(meeting), n);
  meeting.approach = std::max(meeting.touch.gap / times.length - speed, 0.);
}

template <class T, int D>
ContactMotion<D> Meetings<T, D>::relative(const Meeting<T, D>& meeting) const {
  const ContactMotion<D> corner = meeting.side->corners.motion(corner_shares(meeting));
  const ContactMotion<D> point = meeting.side->facets.motion(facet_shares(meeting));
  return {difference<D>(corner.velocity, point.velocity), difference<D>(corner.shift, point.shift)};
}

template <class T, int D>
void Meetings<T, D>::sweep(std::span<const ContactCase> contacts, const ContactTimes& times) {
  for (Meeting<T, D>& meeting : meetings_) {
    push(meeting, contacts[meeting.side->contact], times.drift);
  }
}

// Summed impulses never pull, and friction is limited by the summed normal impulse: a sweep
// corrects what an earlier one has pushed too far.
template <class T, int D>
void Meetings<T, D>::push(Meeting<T, D>& meeting, const ContactCase& law, double drift) {
  const Point<D>& n = meeting.touch.normal;
  const auto [w, apart] = relative(meeting);
  const double gap = meeting.touch.gap + dot<D>(apart, n), speed = dot<D>(w, n);
  const double impulse_now =
      std::max(-(speed + meeting.approach) / meeting.compliance, -meeting.normal_impulse);
  const double shift_now = std::max(-gap / meeting.compliance, -meeting.normal_shift);
  meeting.normal_impulse += impulse_now;
  meeting.normal_shift += shift_now;
  Point<D> friction = meeting.friction_impulse;
  if (law.law != ContactLaw::frictionless) {
    for (int a = 0; a < D; ++a) friction[a] -= (w[a] - speed * n[a]) / meeting.largest_compliance;
    const double size = std::sqrt(dot<D>(friction, friction));
    const double most = law.law == ContactLaw::coulomb ? law.friction * meeting.normal_impulse
                        : meeting.normal_impulse > 0   ? std::numeric_limits<double>::infinity()
                                                       : 0;
    if (size > most) {
      for (double& component : friction) component *= most / size;
    }
  }
  Point<D> impulse, shift;
  for (int a = 0; a < D; ++a) {
    const double along = friction[a] - meeting.friction_impulse[a];
    impulse[a] = impulse_now * n[a] + along;
    shift[a] = shift_now * n[a] + drift * along;
  }
  if (impulse == Point<D>{} && shift == Point<D>{}) return;
  meeting.friction_impulse = friction;
  push_point<D>(meeting.side->corners, corner_shares(meeting), impulse, shift);
  for (int a = 0; a < D; ++a) impulse[a] = -impulse[a], shift[a] = -shift[a];
  push_point<D>(meeting.side->facets, facet_shares(meeting), impulse, shift);
}

template class Meetings<double, 2>;
template class Meetings<double, 3>;
template class Meetings<float, 2>;
template class Meetings<float, 3>;

}  // namespace pliant::undeformed
