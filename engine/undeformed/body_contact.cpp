#include "engine/undeformed/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/geometry/padded.hpp"

namespace pliant::undeformed {

namespace {

constexpr int meeting_sweeps = 4;  // of Gauss-Seidel, as particles carry several corners
constexpr double least_meeting_compliance = 1e-3;  // along the normal, of that without walls
constexpr double too_deep = 0.45;                  // of a corner in a body [spacing]

/// What the point of a facet moves with, each particle once, in the order of the slots.
template <int D>
void append_shares(const ContactSurface<D>& surface, const Touch<D>& touch,
                   std::vector<Share>& shares) {
  const auto first = static_cast<std::ptrdiff_t>(shares.size());
  for (int v = 0; v < D; ++v) {
    if (touch.weight[v] == 0) continue;
    for (const Share& share : surface.shares(surface.facet[touch.facet][v])) {
      shares.push_back({share.slot, touch.weight[v] * share.weight});
    }
  }
  std::sort(shares.begin() + first, shares.end(),
            [](const Share& a, const Share& b) { return a.slot < b.slot; });
  auto last = shares.begin() + first;
  for (auto next = last + 1; next < shares.end(); ++next) {
    if (next->slot == last->slot) {
      last->weight += next->weight;
    } else {
      *++last = *next;
    }
  }
  shares.erase(last + 1, shares.end());
}

/// Calls f(part, first, end) for what one of `shares` equal shares takes of lists of these sizes,
/// which follow each other.
template <class Parts, class Size, class F>
void for_share(const Parts& parts, std::size_t share, std::size_t shares, Size size, F f) {
  std::size_t all = 0;
  for (const auto& part : parts) all += size(*part);
  const std::size_t begin = all * share / shares, end = all * (share + 1) / shares;
  std::size_t first = 0;
  for (const auto& part : parts) {
    const std::size_t next = first + size(*part);
    const std::size_t from = std::max(begin, first), to = std::min(end, next);
    if (from < to) f(*part, from - first, to - first);
    first = next;
  }
}

}  // namespace

template <class T, int D>
BodyContact<T, D>::BodyContact(State<D>& state, const Case& settings, Displacements<T, D> moved)
    : state_(state), settings_(settings), moved_(moved) {}

template <class T, int D>
void BodyContact<T, D>::prepare(double kick, double length, double drift) {
  kick_ = kick;
  length_ = length;
  drift_ = drift;
}

template <class T, int D>
void BodyContact<T, D>::add_phases(PhaseRows& rows, const ContactFields& fields) {
  if (sides_.empty()) return;
  found_.resize(state_.blocks.size());
  rows.reduce("contact: lists", all(fields.motion),
              all(fields.lists + fields.places + fields.normals), [this] { look(); });
  rows.each("contact: places", all(fields.motion + fields.lists), own(fields.places),
            [this](int block) { find_places(block); });
  rows.each("contact: normals", all(fields.places + fields.lists), own(fields.normals),
            [this](int block) { find_normals(block); });
  rows.each("contact: search",
            all(fields.motion + fields.constants + fields.lists + fields.places + fields.normals),
            own(fields.touches), [this](int block) { search(block); });
  rows.reduce("contact: sweeps", all(fields.motion + fields.constants + fields.touches),
              all(fields.motion + fields.touches), [this] { sweep(); });
}

template <class T, int D>
void BodyContact<T, D>::face_each_other() {
  sides_.clear();
  for (int c = 0; c < static_cast<int>(settings_.contacts.size()); ++c) {
    const auto [a, b] = settings_.contacts[c].bodies;
    sides_.push_back(std::make_unique<Side>(*surfaces_[a], *surfaces_[b], c, 1));
    if (a != b) sides_.push_back(std::make_unique<Side>(*surfaces_[b], *surfaces_[a], c, -1));
  }
  has_lists_ = false;
}

// Distances are seen from the frame in which the bodies moved at the last look: bodies that fly
// together keep their lists.
template <class T, int D>
bool BodyContact<T, D>::lists_last() {
  if (!has_lists_) return false;
  bool last = true;
  for (std::size_t c = 0; c < approaches_.size(); ++c) {
    const auto [a, b] = settings_.contacts[c].bodies;
    Approach& approach = approaches_[c];
    const auto first = surfaces_[a]->motion(approach.frame);
    const auto second = a == b ? first : surfaces_[b]->motion(approach.frame);
    approach.moved = first.most + second.most;
    for (int i = 0; i < D; ++i) approach.frame[i] = (first.drift[i] + second.drift[i]) / 2;
    last = last && approach.moved <= approach.free;
  }
  return last;
}

template <class T, int D>
void BodyContact<T, D>::list() {
  for (const auto& surface : surfaces_) surface->mark();
  Approach fresh;
  fresh.free = std::numeric_limits<double>::infinity();
  approaches_.assign(settings_.contacts.size(), fresh);
  for (const auto& side : sides_) {
    double& free = approaches_[side->contact].free;
    free = std::min(free, side->search.list());
  }
  for (const auto& surface : surfaces_) surface->watch_none();
  for (const auto& side : sides_) side->search.watch(side->corners, side->facets);
  has_lists_ = true;
}

template <class T, int D>
void BodyContact<T, D>::look() {
  if (!lists_last()) list();
  may_touch_ = std::any_of(sides_.begin(), sides_.end(), [this](const auto& side) {
    return side->search.may_find(approaches_[side->contact].moved);
  });
}

template <class T, int D>
void BodyContact<T, D>::find_places(int block) {
  if (!may_touch_) return;
  for_share(
      surfaces_, block, found_.size(),
      [](const Surface& surface) { return surface.watched_corners(); },
      [](Surface& surface, std::size_t first, std::size_t end) {
        surface.find_places(first, end);
      });
}

template <class T, int D>
void BodyContact<T, D>::find_normals(int block) {
  if (!may_touch_) return;
  for_share(
      surfaces_, block, found_.size(),
      [](const Surface& surface) { return surface.watched_facets(); },
      [](Surface& surface, std::size_t first, std::size_t end) {
        surface.find_normals(first, end);
      });
}

template <class T, int D>
void BodyContact<T, D>::search(int block) {
  Found& found = found_[block];
  found.meetings.clear();
  found.shares.clear();
  if (!may_touch_) return;
  for_share(
      sides_, block, found_.size(), [](const Side& side) { return side.search.candidates(); },
      [&](const Side& side, std::size_t first, std::size_t end) {
        found.touches.clear();
        side.search.find(approaches_[side.contact].moved, first, end, found.touches);
        meet(side, found);
      });
}

template <class T, int D>
void BodyContact<T, D>::sweep() {
  for (int sweep = 0; sweep < meeting_sweeps; ++sweep) {
    for (Found& found : found_) {
      for (Meeting& meeting : found.meetings) push(meeting);
    }
  }
  add_totals();
}

template <class T, int D>
void BodyContact<T, D>::meet(const Side& side, Found& found) {
  for (const Touch<D>& touch : found.touches) {
    Meeting meeting{&side, &found.shares, touch, found.shares.size(), 0, 0, 0, 0, {}};
    meet_before(meeting, found.shares);
    const auto sum = [&](const HeldDirections<D>& of_corners, const HeldDirections<D>& of_facets) {
      return compliance<T, D>(side.corners.body(), of_corners, corner_shares(meeting),
                              touch.normal) +
             compliance<T, D>(side.facets.body(), of_facets, facet_shares(meeting), touch.normal);
    };
    meeting.largest_compliance = sum({}, {});
    meeting.compliance = sum(side.corners.held(), side.facets.held());
    if (meeting.compliance < least_meeting_compliance * meeting.largest_compliance) continue;
    meeting.apart = displaced(meeting);
    // Velocities of the middle of a step may close what was open at its start.
    const double speed = dot<D>(slip(meeting), touch.normal);
    const bool in_middle = drift_ == length_;
    meeting.approach = in_middle ? std::max(touch.gap / length_ - speed, 0.) : 0;
    found.meetings.push_back(meeting);
  }
}

// The corner pushes the point that it faced when the forces of the step acted: without slip the two
// are one, and with it the pair exerts no torque.
template <class T, int D>
void BodyContact<T, D>::meet_before(Meeting& meeting, std::vector<Share>& shares) {
  Touch<D>& touch = meeting.touch;
  const Surface& facets = meeting.side->facets;
  const std::array<Point<D>, D> c = facets.places(touch.facet);
  Point<D> w = carried<T, D>(meeting.side->corners.body().velocity, corner_shares(meeting));
  for (int v = 0; v < D; ++v) {
    if (touch.weight[v] == 0) continue;
    const Point<D> u = carried<T, D>(
        facets.body().velocity, facets.surface().shares(facets.surface().facet[touch.facet][v]));
    for (int a = 0; a < D; ++a) w[a] -= touch.weight[v] * u[a];
  }
  const double speed = dot<D>(w, touch.normal);
  Point<D> before;
  for (int a = 0; a < D; ++a) {
    before[a] = -drift_ * (w[a] - speed * touch.normal[a]);
    for (int v = 0; v < D; ++v) before[a] += touch.weight[v] * c[v][a];
  }
  touch.weight = nearest_weights(c, before);
  shares.resize(meeting.first_share);
  append_shares<D>(facets.surface(), touch, shares);
  meeting.end_share = shares.size();
}

template <class T, int D>
Point<D> BodyContact<T, D>::relative(const Meeting& meeting,
                                     const std::array<Buffer<T>, D>& of_corner,
                                     const std::array<Buffer<T>, D>& of_facet) const {
  return difference<D>(carried<T, D>(of_corner, corner_shares(meeting)),
                       carried<T, D>(of_facet, facet_shares(meeting)));
}

template <class T, int D>
Point<D> BodyContact<T, D>::displaced(const Meeting& meeting) const {
  return relative(meeting, meeting.side->corners.displacement(),
                  meeting.side->facets.displacement());
}

template <class T, int D>
Point<D> BodyContact<T, D>::slip(const Meeting& meeting) const {
  return relative(meeting, meeting.side->corners.body().velocity,
                  meeting.side->facets.body().velocity);
}

// Sums of impulses never pull, and friction is bounded by the sum of those along the normal: what
// one sweep has pushed too far the next one takes back.
template <class T, int D>
void BodyContact<T, D>::push(Meeting& meeting) {
  const Side& side = *meeting.side;
  const Point<D>& n = meeting.touch.normal;
  const ContactCase& law = settings_.contacts[side.contact];
  const Point<D> apart = difference<D>(displaced(meeting), meeting.apart);
  Point<D> w = slip(meeting);
  const double gap = meeting.touch.gap + dot<D>(apart, n), speed = dot<D>(w, n);
  const double pushed = std::max(-(speed + meeting.approach) / meeting.compliance, -meeting.pushed);
  const double moved = std::max(-gap / meeting.compliance, -meeting.moved);
  meeting.pushed += pushed;
  meeting.moved += moved;
  Point<D> rubbed = meeting.rubbed;
  if (law.law != ContactLaw::frictionless) {
    for (int a = 0; a < D; ++a) rubbed[a] -= (w[a] - speed * n[a]) / meeting.largest_compliance;
    const double size = std::sqrt(dot<D>(rubbed, rubbed));
    const double most = law.law == ContactLaw::coulomb ? law.friction * meeting.pushed
                        : meeting.pushed > 0           ? std::numeric_limits<double>::infinity()
                                                       : 0;
    if (size > most) {
      for (double& component : rubbed) component *= most / size;
    }
  }
  Point<D> impulse, shift;
  for (int a = 0; a < D; ++a) {
    const double along = rubbed[a] - meeting.rubbed[a];
    impulse[a] = pushed * n[a] + along;
    shift[a] = moved * n[a] + drift_ * along;
  }
  meeting.rubbed = rubbed;
  undeformed::push<T, D>(side.corners.body(), side.corners.displacement(), side.corners.held(),
                         corner_shares(meeting), impulse, shift);
  for (int a = 0; a < D; ++a) impulse[a] = -impulse[a], shift[a] = -shift[a];
  undeformed::push<T, D>(side.facets.body(), side.facets.displacement(), side.facets.held(),
                         facet_shares(meeting), impulse, shift);
}

template <class T, int D>
void BodyContact<T, D>::add_totals() {
  const double inertia = state_.clock.mass_scaling * (1 + state_.clock.damping * kick_ / 2);
  std::fill(state_.contact_force.begin(), state_.contact_force.end(), Point<D>{});
  for (const Found& found : found_) {
    for (const Meeting& meeting : found.meetings) {
      const int contact = meeting.side->contact;
      for (int a = 0; a < D; ++a) {
        const double on_first = inertia * meeting.side->sign *
                                (meeting.pushed * meeting.touch.normal[a] + meeting.rubbed[a]);
        state_.contact_impulse[contact][a] += on_first;
        state_.contact_force[contact][a] += on_first / kick_;
      }
      const double lost = -inertia * dot<D>(meeting.rubbed, slip(meeting));
      state_.energy.friction += lost;
      state_.power.friction += lost / kick_;
    }
  }
}

template <class T, int D>
std::optional<Overlap> BodyContact<T, D>::deepest() const {
  std::optional<Overlap> deepest;
  for (const Found& found : found_) {
    for (const Meeting& meeting : found.meetings) {
      const Side& side = *meeting.side;
      const double depth = -meeting.touch.gap;
      if (depth <= too_deep * side.facets.spacing()) continue;
      if (deepest && depth <= deepest->depth) continue;
      deepest = {side.contact, depth, padded<D>(side.corners.place(meeting.touch.corner))};
    }
  }
  return deepest;
}

template class BodyContact<double, 2>;
template class BodyContact<double, 3>;
template class BodyContact<float, 2>;
template class BodyContact<float, 3>;

}  // namespace pliant::undeformed
