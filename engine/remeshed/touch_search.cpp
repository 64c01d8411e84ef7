#include "engine/remeshed/touch_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/remeshed/resources.hpp"
#include "engine/remeshed/surface_fits.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;
using scheduler::Reach;

constexpr double fit_radius = 2.6;  // [h], as that of ghosts
// How far apart pressed surfaces may stand [h]: none of it would let the noise of phi open a
// surface that is pressed, more touches too early, which costs energy.
constexpr double touching_gap = 0.01;
constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double clearly_apart = 1;  // [h], where no fit is needed to tell
constexpr double bonded_gap = 0.5;   // [h]: the sides of a bonded body carry no load

/// Partition of unity over the layers of ghosts: 1 at `centre`, 0 one spacing away.
double hat(double distance, double centre) { return std::max(0., 1 - std::abs(distance - centre)); }

/// (RP.67): share of the surface of a ghost at `distance` from it, both over h.
template <int D>
double surface_share(double distance) {
  if constexpr (D == 2) return 2 * hat(distance, 1) - hat(distance, 2);
  return 3 * (hat(distance, 1) - hat(distance, 2)) + hat(distance, 3);
}

/// A place over h, in periodic directions in the first period.
template <int D>
double in_first_period(double x, const Lattice<D>& lattice, int axis) {
  const std::int32_t n = lattice.period[axis];
  return n == 0 ? x : x - n * std::floor(x / n);
}

/// A point as sites have it.
template <int D>
Point<D> place(const Point<D>& x, const Lattice<D>& lattice) {
  Point<D> at;
  for (int a = 0; a < D; ++a) {
    at[a] = in_first_period<D>((x[a] - lattice.origin[a]) / lattice.spacing - 0.5, lattice, a);
  }
  return at;
}

}  // namespace

/// Fits of another body about a foot point. Kept by each thread, so that a warm search allocates
/// nothing.
template <class T, int D>
class TouchSearch<T, D>::Partner {
 public:
  /// The gap to the body's surface at x [h], as its level set tells; infinity where there is too
  /// little of the body.
  double gap(const Surface& surface, const Lattice<D>& lattice, const Point<D>& x,
             double farthest = unlimited) {
    constexpr double none = std::numeric_limits<double>::infinity();
    surface_ = &surface;
    particles_.clear();
    around_.clear();
    const Point<D> at = place<D>(x, lattice);
    if (!surface.holds(at, lattice, 0)) return none;
    double nearest = fit_radius, beyond = 0;  // the nearest sample, and its bound of the gap
    surface.cells.any_near(at, [&](const Site<D>& site, const Cell<D>& shift) {
      Position<D> r;
      for (int a = 0; a < D; ++a) r[a] = site.position[a] + shift[a] - at[a];
      const double fraction = r.squaredNorm() / (fit_radius * fit_radius);
      if (fraction >= 1) return false;
      const FitParticle<D> sample{site.slot, (1 - fraction) * (1 - fraction),
                                  surface.level_set[site.slot], r};
      if (const double distance = r.norm(); distance < nearest) {
        nearest = distance;
        beyond = sample.surface_distance - distance;
      }
      around_.push_back(sample);
      if (surface.record[site.slot] >= 0) particles_.push_back(sample);
      return false;
    });
    if (beyond > farthest || around_.empty() || !fit(around_)) return none;
    double gap = 0;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      gap += coefficient_[i] * around_[i].surface_distance;
    }
    return gap;
  }

  /// Adds the fit of the body's surface particles there to the last of `touches`; false where they
  /// do not determine it.
  bool add_to(BodyTouches<T, D>& touches) {
    if (!fit(particles_)) return false;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      touches.record.push_back(surface_->record[particles_[i].slot]);
      touches.coefficient.push_back(static_cast<T>(coefficient_[i]));
    }
    touches.begin.push_back(static_cast<std::int64_t>(touches.record.size()));
    return true;
  }

  /// Where the interface ends at a free surface, a ghost beyond it and not inside the other body:
  /// adds the fit of the other body's particles and ghosts at the ghost. False elsewhere.
  bool add_bond(BlockGhosts<T, D>& ghosts, std::int32_t ghost, const Surface& surface,
                const Body<T, D>& body, const Body<T, D>& other_body, int other,
                const Point<D>& foot) {
    const double h = body.lattice.spacing;
    const std::int32_t slot = ghosts.slot[ghost];
    const Point<D> x = body.position(slot, body.population.layout.cell(slot));
    const double own_distance = body.stage[0].get(Field::level_set)[slot] / h;
    const double distance = gap(surface, other_body.lattice, x);
    if (distance >= own_distance || distance < -0.5 * own_distance) return false;
    // Not those ghosts of the other body that are bonded to this one, with half a cell to spare.
    Position<D> to_foot;
    for (int a = 0; a < D; ++a) to_foot[a] = (foot[a] - x[a]) / h;
    const auto is_bonded = [&](const FitParticle<D>& q) {
      return surface.record[q.slot] < 0 &&
             (q.position - to_foot).norm() < q.surface_distance + 0.5;
    };
    around_.erase(std::remove_if(around_.begin(), around_.end(), is_bonded), around_.end());
    if (!fit(around_)) return false;
    BodyBonds<T>& bonds = ghosts.bonds;
    bonds.ghost.push_back(ghost);
    bonds.body.push_back(other);
    for (std::size_t i = 0; i < around_.size(); ++i) {
      bonds.slot.push_back(surface.slot[around_[i].slot]);
      bonds.coefficient.push_back(static_cast<T>(coefficient_[i]));
    }
    bonds.begin.push_back(static_cast<std::int64_t>(bonds.slot.size()));
    return true;
  }

 private:
  bool fit(const FitParticles<D>& particles) {
    const FitSite<D> site = {Position<D>::Zero(), Position<D>::Zero(), 0};
    coefficient_.clear();
    at_foot_.clear();
    return fit_in_all_directions<D>(particles, site, coefficient_, at_foot_);
  }

  const Surface* surface_ = nullptr;
  FitParticles<D> particles_, around_;
  std::vector<double> coefficient_, at_foot_;
};

template <class T, int D>
TouchSearch<T, D>::TouchSearch(State<T, D>& state, const std::vector<ContactCase>& contacts)
    : state_(state),
      contacts_(contacts),
      contacts_of_(state.bodies.size()),
      surfaces_(state.bodies.size()) {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    for (const int body : contacts_[c].bodies) contacts_of_[body].push_back(static_cast<int>(c));
  }
}

template <class T, int D>
void TouchSearch<T, D>::add_phases(std::vector<Phase>& phases) {
  phases.push_back({"touches: samples",
                    -1,
                    {{resource::drift(0)}},
                    {{resource::surface_samples}},
                    Phase::Extent::per_block,
                    {},
                    [this](int block) { find_samples(block); }});
  phases.push_back({"touches: cells",
                    -1,
                    {{resource::surface_samples, Reach::all}},
                    {{resource::surface_cells, Reach::all}},
                    Phase::Extent::once,
                    {},
                    [this](int) { sort_samples(); }});
  phases.push_back(
      {"touches",
       -1,
       {{resource::surface_cells, Reach::all}, {resource::drift(0), Reach::neighbours}},
       {{resource::touches}},
       Phase::Extent::per_block,
       {},
       [this](int block) { find_touches(block); }});
}

template <class T, int D>
void TouchSearch<T, D>::find_samples(int block) {
  const auto [owner, local] = state_.blocks[block];
  std::vector<Sample>& samples = samples_[block];
  samples.clear();
  if (contacts_of_[owner].empty()) return;
  const Body<T, D>& body = state_.bodies[owner];
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  const T* phi = body.stage[0].get(Field::level_set);
  const auto add = [&](std::int64_t slot, const Cell<D>& cell, std::int32_t record) {
    Sample sample{{{}, cell, 0}, static_cast<std::int32_t>(slot), record, phi[slot] / h};
    for (int a = 0; a < D; ++a) {
      const T drift = body.stage[0].get(Field::displacement, a)[slot];
      sample.site.position[a] = in_first_period<D>(cell[a] + drift / h, body.lattice, a);
    }
    samples.push_back(sample);
  };
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[local];
  const int first_segment = layout.blocks()[local].first_segment;
  for (const kernels::SurfacePack& pack : ghosts.packs) {
    const kernels::Segment<D>& segment = layout.segments()[first_segment + pack.segment];
    Cell<D> cell = segment.cell;
    cell[0] += static_cast<std::int32_t>(pack.first - segment.first);
    std::int32_t record = pack.record;
    for (int l = 0; l < Layout<D>::pack; ++l, ++cell[0]) {
      if (pack.lanes >> l & 1) add(pack.first + l, cell, record++);
    }
  }
  for (const std::int32_t slot : ghosts.slot) add(slot, layout.cell(slot), -1);
}

template <class T, int D>
void TouchSearch<T, D>::sort_samples() {
  for (std::size_t body = 0; body < surfaces_.size(); ++body) gather(static_cast<int>(body));
  for (const ContactCase& contact : contacts_) {
    if (!are_near(contact)) continue;
    for (const int body : contact.bodies) surfaces_[body].is_near_another = true;
  }
  for (std::size_t body = 0; body < surfaces_.size(); ++body) {
    Surface& surface = surfaces_[body];
    if (!surface.is_near_another) continue;
    const std::size_t count = surface.record.size();
    surface.cells.cover(surface.lower, surface.upper, state_.bodies[body].lattice.period,
                        fit_radius, count);
    surface.cells.sort(count, [&](auto&& f) {
      for (std::size_t b = 0; b < samples_.size(); ++b) {
        if (state_.blocks[b].body != static_cast<int>(body)) continue;
        for (const Sample& sample : samples_[b]) f(sample.site);
      }
    });
  }
}

template <class T, int D>
void TouchSearch<T, D>::gather(int body) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Surface& surface = surfaces_[body];
  surface.lower.fill(infinity);
  surface.upper.fill(-infinity);
  surface.is_near_another = false;
  surface.slot.clear();
  surface.record.clear();
  surface.level_set.clear();
  for (std::size_t b = 0; b < samples_.size(); ++b) {
    if (state_.blocks[b].body != body) continue;
    for (Sample& sample : samples_[b]) {
      sample.site.slot = static_cast<std::int32_t>(surface.record.size());
      surface.slot.push_back(sample.slot);
      surface.record.push_back(sample.record);
      surface.level_set.push_back(sample.level_set);
      for (int a = 0; a < D; ++a) {
        surface.lower[a] = std::min(surface.lower[a], sample.site.position[a]);
        surface.upper[a] = std::max(surface.upper[a], sample.site.position[a]);
      }
    }
  }
}

// Boxes hold ghosts, so that bodies whose boxes are apart are far from touching.
template <class T, int D>
bool TouchSearch<T, D>::are_near(const ContactCase& contact) const {
  const Surface& first = surfaces_[contact.bodies[0]];
  const Surface& second = surfaces_[contact.bodies[1]];
  const Lattice<D>& lattice = state_.bodies[contact.bodies[0]].lattice;
  const Lattice<D>& other = state_.bodies[contact.bodies[1]].lattice;
  for (int a = 0; a < D; ++a) {
    if (lattice.period[a] != 0) continue;
    const double shift = (other.origin[a] - lattice.origin[a]) / lattice.spacing;
    if (first.lower[a] > second.upper[a] + shift || second.lower[a] + shift > first.upper[a]) {
      return false;
    }
  }
  return true;
}

template <class T, int D>
void TouchSearch<T, D>::find_touches(int block) {
  const auto [owner, local] = state_.blocks[block];
  BlockGhosts<T, D>& ghosts = state_.bodies[owner].population.ghosts[local];
  BodyTouches<T, D>& touches = ghosts.touches;
  touches.clear();
  ghosts.bonds.clear();
  if (!surfaces_[owner].is_near_another) return;
  thread_local Partner partner;
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    // Fits about a wall tell no traction of the free surface.
    if (ghosts.wall[g] >= 0 || ghosts.surface_sum[g] < T(0.5)) continue;
    find_touch(block, static_cast<std::int32_t>(g), partner);
  }
  touches.traction.resize(touches.ghost.size());
}

// Whether the ghost's foot point, which has moved about as far as the ghost, may lie on another
// body.
template <class T, int D>
bool TouchSearch<T, D>::may_touch(int owner, const BlockGhosts<T, D>& ghosts,
                                  std::int32_t ghost) const {
  const Body<T, D>& body = state_.bodies[owner];
  Point<D> x = ghosts.foot[ghost];
  for (int a = 0; a < D; ++a) {
    x[a] += body.stage[0].get(Field::displacement, a)[ghosts.slot[ghost]];
  }
  const auto& contacts = contacts_of_[owner];
  return std::any_of(contacts.begin(), contacts.end(), [&](int contact) {
    const int other = other_body(contact, owner);
    const Lattice<D>& lattice = state_.bodies[other].lattice;
    return surfaces_[other].is_near_another &&
           surfaces_[other].holds(place<D>(x, lattice), lattice, fit_radius);
  });
}

// The nearest of the bodies that may touch there.
template <class T, int D>
void TouchSearch<T, D>::find_touch(int block, std::int32_t ghost, Partner& partner) {
  const auto [owner, local] = state_.blocks[block];
  Body<T, D>& body = state_.bodies[owner];
  BlockGhosts<T, D>& ghosts = body.population.ghosts[local];
  const double h = body.lattice.spacing;
  if (!may_touch(owner, ghosts, ghost)) return;
  const Point<D> x = foot_point(body, ghosts, ghost);
  const auto gap_to = [&](int contact) {
    const int other = other_body(contact, owner);
    if (!surfaces_[other].is_near_another) return clearly_apart;
    const double gap =
        partner.gap(surfaces_[other], state_.bodies[other].lattice, x, clearly_apart);
    const bool bonded = contacts_[contact].kind == ContactCase::Kind::bonded;
    return gap < (bonded ? bonded_gap : touching_gap) ? gap : clearly_apart;
  };
  int nearest = -1;
  double least = clearly_apart;
  for (const int contact : contacts_of_[owner]) {
    const double gap = gap_to(contact);
    if (gap >= least) continue;
    least = gap;
    nearest = contact;
  }
  if (nearest < 0) return;
  const int other = other_body(nearest, owner);
  if (contacts_[nearest].kind == ContactCase::Kind::bonded &&
      partner.add_bond(ghosts, ghost, surfaces_[other], body, state_.bodies[other], other, x)) {
    return;
  }
  gap_to(nearest);  // the partner's fits were others
  if (!partner.add_to(ghosts.touches)) return;
  const double distance = body.stage[0].get(Field::level_set)[ghosts.slot[ghost]] / h;
  ghosts.touches.ghost.push_back(ghost);
  ghosts.touches.contact.push_back(nearest);
  ghosts.touches.gap.push_back(static_cast<T>(least * h));
  ghosts.touches.area.push_back(static_cast<T>(std::pow(h, D - 1) * surface_share<D>(distance)));
}

// It moves with the particles of its fit.
template <class T, int D>
Point<D> TouchSearch<T, D>::foot_point(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                       std::int32_t ghost) const {
  Point<D> x = ghosts.foot[ghost];
  for (int a = 0; a < D; ++a) {
    const T* drift = body.stage[0].get(Field::displacement, a);
    for (std::int64_t k = ghosts.begin[ghost]; k < ghosts.begin[ghost + 1]; ++k) {
      x[a] += ghosts.surface[k] * drift[ghosts.neighbour[k]];
    }
  }
  return x;
}

template class TouchSearch<double, 2>;
template class TouchSearch<double, 3>;

}  // namespace pliant::remeshed
