#include "engine/undeformed/contact/body_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <pliant/error.hpp>
#include <utility>

#include "engine/geometry/padded.hpp"

namespace pliant::undeformed {

namespace {

// Gauss-Seidel sweeps, since particles carry several corners. What remains after them shakes bodies
// that rest on each other. Where many particles carry each corner, neighbouring corners push nearly
// the same particles, and sweeps converge slowly.
constexpr int few_sweeps = 4, most_sweeps = 256;
// Where velocities belong to the end of a step, shifts do not follow from impulses, and what few
// sweeps leave of both strains bodies that rest on each other.
constexpr int sweeps_of_end_velocities = 32;
constexpr double over_relaxation = 1.4;  // halves the sweeps where there are many
constexpr double settled = 1e-3;         // of the largest change in the first sweep
constexpr std::size_t many_carriers = 5;
constexpr double too_deep = 0.45;  // depth of a corner in a body [spacing]

/// Calls f(part, first, end) for the elements of one of `shares` equal shares of lists of these
/// sizes, taken one after another.
template <class Parts, class Size, class F>
void for_share(const Parts& parts, std::size_t share, std::size_t shares, Size size, F f) {
  std::size_t all = 0;
  for (const auto& part : parts) all += std::invoke(size, *part);
  const std::size_t begin = all * share / shares, end = all * (share + 1) / shares;
  std::size_t first = 0;
  for (const auto& part : parts) {
    const std::size_t next = first + std::invoke(size, *part);
    const std::size_t from = std::max(begin, first), to = std::min(end, next);
    if (from < to) std::invoke(f, *part, from - first, to - first);
    first = next;
  }
}

}  // namespace

template <class T, int D>
BodyContact<T, D>::BodyContact(State<D>& state, const Case& settings, Displacements<T, D> moved)
    : state_(state), settings_(settings), moved_(moved) {}

template <class T, int D>
void BodyContact<T, D>::prepare(double kick, double length, double drift) {
  times_ = {kick, length, drift};
}

template <class T, int D>
void BodyContact<T, D>::add_phases(PhaseRows& rows, const ContactFields& fields) {
  if (!exists()) return;
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
  ties_.clear();
  for (int c = 0; c < static_cast<int>(settings_.contacts.size()); ++c) {
    const auto [a, b] = settings_.contacts[c].bodies;
    if (settings_.contacts[c].law == ContactLaw::tied) {
      tie(c);
      continue;
    }
    sides_.push_back(std::make_unique<Side>(*surfaces_[a], *surfaces_[b], c, 1));
    if (a != b) sides_.push_back(std::make_unique<Side>(*surfaces_[b], *surfaces_[a], c, -1));
  }
  most_sweeps_ = few_sweeps;
  relaxation_ = 1;
  std::size_t carriers = 0;
  for (const auto& surface : surfaces_) {
    carriers += surface->marked().size();
    for (std::int32_t corner = 0; corner < surface->corners(); ++corner) {
      if (surface->shares(corner).size() < many_carriers) continue;
      most_sweeps_ = most_sweeps;
      relaxation_ = over_relaxation;
    }
  }
  state_.contact_marks.assign(carriers, {});
  state_.has_new_marks = true;
}

template <class T, int D>
void BodyContact<T, D>::tie(int contact) {
  const auto [a, b] = settings_.contacts[contact].bodies;
  ties_.emplace_back(*surfaces_[a], *surfaces_[b], contact);
  if (ties_.back().hold()) return;
  throw InputError(
      fmt::format("bodies `{}` and `{}` are tied but do not meet; let their surfaces touch at the "
                  "start",
                  settings_.bodies[a].name, settings_.bodies[b].name));
}

template <class T, int D>
void BodyContact<T, D>::read_motion() {
  for (const auto& surface : surfaces_) surface->read_motion();
}

template <class T, int D>
bool BodyContact<T, D>::lists_hold() {
  bool hold = true;
  for (const auto& side : sides_) hold = side->search.holds() && hold;
  return hold;
}

template <class T, int D>
void BodyContact<T, D>::list() {
  for (const auto& side : sides_) side->search.list(state_.has_new_marks);
  for (const auto& surface : surfaces_) surface->watch_none();
  for (const auto& side : sides_) side->search.watch();
  for (TiedSurfaces<T, D>& ties : ties_) ties.watch();
}

template <class T, int D>
void BodyContact<T, D>::take_marks() {
  auto next = state_.contact_marks.begin();
  for (const auto& surface : surfaces_) {
    const auto count = static_cast<std::ptrdiff_t>(surface->marked().size());
    std::copy_n(next, count, surface->marked().begin());
    next += count;
  }
}

template <class T, int D>
void BodyContact<T, D>::give_marks() {
  auto next = state_.contact_marks.begin();
  for (const auto& surface : surfaces_) {
    next = std::copy(surface->marked().begin(), surface->marked().end(), next);
  }
}

template <class T, int D>
void BodyContact<T, D>::look() {
  if (state_.has_new_marks) take_marks();
  read_motion();
  if (state_.has_new_marks) list();
  state_.has_new_marks = false;
  if (!lists_hold()) {
    for (const auto& side : sides_) side->search.expect_marks();
    for (const auto& surface : surfaces_) surface->mark();
    give_marks();
    list();
    lists_hold();
  }
  acts_ = !ties_.empty() || std::any_of(sides_.begin(), sides_.end(),
                                        [](const auto& side) { return side->search.may_find(); });
}

template <class T, int D>
void BodyContact<T, D>::find_places(int block) {
  if (!acts_) return;
  for_share(surfaces_, block, found_.size(), &Surface::watched_corners, &Surface::find_places);
  for_share(surfaces_, block, found_.size(), &Surface::watched_carriers, &Surface::read_velocities);
}

template <class T, int D>
void BodyContact<T, D>::find_normals(int block) {
  if (!acts_) return;
  for_share(surfaces_, block, found_.size(), &Surface::watched_facets, &Surface::find_normals);
}

template <class T, int D>
void BodyContact<T, D>::search(int block) {
  Found& found = found_[block];
  found.pairs.clear();
  if (!acts_) return;
  for_share(
      sides_, block, found_.size(), [](const Side& side) { return side.search.candidates(); },
      [&](const Side& side, std::size_t first, std::size_t end) {
        found.touches.clear();
        side.search.find(first, end, found.touches);
        found.pairs.add(side, found.touches, times_);
      });
}

template <class T, int D>
void BodyContact<T, D>::sweep() {
  std::fill(state_.contact_force.begin(), state_.contact_force.end(), Point<D>{});
  if (!acts_) return;
  for (TiedSurfaces<T, D>& ties : ties_) ties.measure();
  const bool in_middle = times_.drift == times_.length;
  const int most = in_middle ? most_sweeps_ : std::max(most_sweeps_, sweeps_of_end_velocities);
  double first = 0;
  for (int sweep = 0; sweep < most; ++sweep) {
    for (TiedSurfaces<T, D>& ties : ties_) ties.sweep();
    double change = 0;
    for (Found& found : found_) {
      change = std::max(change, found.pairs.sweep(settings_.contacts, times_, relaxation_));
    }
    first = std::max(first, change);
    if (sweep + 1 >= few_sweeps && change <= settled * first) break;
  }
  add_totals();
  const double rate = state_.clock.inertia(times_.kick) / times_.kick;
  for (const auto& surface : surfaces_) surface->write_motion(rate);
}

template <class T, int D>
void BodyContact<T, D>::add_totals() {
  const double inertia = state_.clock.inertia(times_.kick);
  for (const TiedSurfaces<T, D>& ties : ties_) {
    Point<D> on_first = ties.impulse();
    for (double& component : on_first) component *= inertia;
    add_force(ties.contact(), on_first);
  }
  for (const Found& found : found_) {
    for (std::size_t k = 0; k < found.pairs.all().size(); ++k) {
      const ContactPair<T, D>& pair = found.pairs.all()[k];
      const Point<D>& friction = found.pairs.friction(k);
      Point<D> on_first;
      for (int a = 0; a < D; ++a) {
        on_first[a] =
            inertia * pair.side->sign * (pair.normal_impulse * pair.touch.normal[a] + friction[a]);
      }
      add_force(pair.side->contact, on_first);
      const double lost = -inertia * dot<D>(friction, found.pairs.slip(pair));
      state_.energy.friction += lost;
      state_.power.friction += lost / times_.kick;
    }
  }
}

template <class T, int D>
void BodyContact<T, D>::add_force(int contact, const Point<D>& impulse) {
  for (int a = 0; a < D; ++a) {
    state_.contact_impulse[contact][a] += impulse[a];
    state_.contact_force[contact][a] += impulse[a] / times_.kick;
  }
}

template <class T, int D>
std::optional<Overlap> BodyContact<T, D>::deepest() const {
  std::optional<Overlap> deepest;
  for (const Found& found : found_) {
    for (const ContactPair<T, D>& pair : found.pairs.all()) {
      const Side& side = *pair.side;
      const double depth = -pair.touch.gap;
      if (depth <= too_deep * side.facets.spacing()) continue;
      if (deepest && depth <= deepest->depth) continue;
      deepest = {side.contact, depth, padded<D>(side.corners.place(pair.touch.corner))};
    }
  }
  return deepest;
}

template class BodyContact<double, 2>;
template class BodyContact<double, 3>;
template class BodyContact<float, 2>;
template class BodyContact<float, 3>;

}  // namespace pliant::undeformed
