#include "engine/remeshed/contact/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/contact/opposing_fit.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "engine/remeshed/state/resources.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;

// Largest gap of surfaces in contact [h]. With 0, noise of phi would open a pressed surface; with
// more, contact would begin too early, which costs energy.
constexpr double pressed_gap = 0.01;
constexpr double clearly_apart = 1;  // [h], larger gaps need no fit
constexpr double apart = std::numeric_limits<double>::infinity();

/// Partition of unity over the layers of ghosts: 1 at `centre`, 0 one spacing away.
double hat(double distance, double centre) { return std::max(0., 1 - std::abs(distance - centre)); }

/// (RP.68): the share of the surface that a ghost at `distance` from it represents, both over h.
template <int D>
double surface_share(double distance) {
  if constexpr (D == 2) return 2 * hat(distance, 1) - hat(distance, 2);
  return 3 * (hat(distance, 1) - hat(distance, 2)) + hat(distance, 3);
}

}  // namespace

template <class T, int D>
ContactSearch<T, D>::ContactSearch(State<T, D>& state, const std::vector<ContactCase>& contacts)
    : state_(state),
      contacts_(contacts),
      contacts_of_(state.bodies.size()),
      surfaces_(state.bodies.size()) {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    for (const int body : contacts_[c].bodies) contacts_of_[body].push_back(static_cast<int>(c));
  }
}

template <class T, int D>
void ContactSearch<T, D>::add_phases(std::vector<Phase>& phases) {
  using namespace resource;
  using enum Group;
  PhaseRows rows(phases);
  rows.each("contact search: samples",
            own(particles(drift) + ghosts(drift) + particles(constants) + ghosts(constants) +
                whole(fits)),
            own(whole(surface_samples)), [this](int block) { find_samples(block); });
  rows.reduce("contact search: cells", all(whole(surface_samples)),
              all(whole(surface_samples) + whole(surface_cells)), [this] { sort_samples(); });
  rows.each("contact search: points",
            all(whole(surface_cells)) + near(particles(drift) + whole(fits)) +
                own(ghosts(drift) + ghosts(constants)),
            own(whole(contact_points) + whole(tractions)),
            [this](int block) { find_contact_points(block); });
}

template <class T, int D>
void ContactSearch<T, D>::find_samples(int block) {
  const auto [owner, local] = state_.blocks[block];
  std::vector<Sample>& samples = samples_[block];
  samples.clear();
  if (contacts_of_[owner].empty()) return;
  const Body<T, D>& body = state_.bodies[owner];
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  const T* phi = body.stage[0].get(Field::level_set);
  const auto add = [&](std::int64_t slot, const Cell<D>& cell, std::int32_t record) {
    Sample sample{{{}, 0}, record, phi[slot] / h};
    for (int a = 0; a < D; ++a) {
      const T drift = body.stage[0].get(Field::drift, a)[slot];
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
void ContactSearch<T, D>::sort_samples() {
  for (std::size_t body = 0; body < surfaces_.size(); ++body) gather(static_cast<int>(body));
  for (const ContactCase& contact : contacts_) {
    if (!are_near(contact)) continue;
    for (const int body : contact.bodies) surfaces_[body].is_near_another = true;
  }
  for (std::size_t body = 0; body < surfaces_.size(); ++body) {
    SurfaceSamples<D>& surface = surfaces_[body];
    if (!surface.is_near_another) continue;
    const std::size_t count = surface.record.size();
    surface.cells.cover(surface.lower, surface.upper, period_of<D>(state_.bodies[body].lattice),
                        contact_fit_radius, count);
    surface.cells.sort(count, [&](auto&& f) {
      for (std::size_t b = 0; b < samples_.size(); ++b) {
        if (state_.blocks[b].body != static_cast<int>(body)) continue;
        for (const Sample& sample : samples_[b]) f(sample.site);
      }
    });
  }
}

template <class T, int D>
void ContactSearch<T, D>::gather(int body) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SurfaceSamples<D>& surface = surfaces_[body];
  surface.lower.fill(infinity);
  surface.upper.fill(-infinity);
  surface.is_near_another = false;
  surface.record.clear();
  surface.level_set.clear();
  for (std::size_t b = 0; b < samples_.size(); ++b) {
    if (state_.blocks[b].body != body) continue;
    for (Sample& sample : samples_[b]) {
      sample.site.label = static_cast<std::int32_t>(surface.record.size());
      surface.record.push_back(sample.record);
      surface.level_set.push_back(sample.level_set);
      for (int a = 0; a < D; ++a) {
        surface.lower[a] = std::min(surface.lower[a], sample.site.position[a]);
        surface.upper[a] = std::max(surface.upper[a], sample.site.position[a]);
      }
    }
  }
}

// Boxes include ghosts, so bodies with separate boxes are far from touching.
template <class T, int D>
bool ContactSearch<T, D>::are_near(const ContactCase& contact) const {
  const SurfaceSamples<D>& first = surfaces_[contact.bodies[0]];
  const SurfaceSamples<D>& second = surfaces_[contact.bodies[1]];
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
void ContactSearch<T, D>::find_contact_points(int block) {
  const auto [owner, local] = state_.blocks[block];
  BlockGhosts<T, D>& ghosts = state_.bodies[owner].population.ghosts[local];
  ContactPoints<T, D>& contact_points = ghosts.contact_points;
  contact_points.clear();
  if (!surfaces_[owner].is_near_another) return;
  thread_local OpposingFit<T, D> opposing;
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    // Fits around a wall give no traction of the free surface.
    if (ghosts.wall[g] >= 0 || ghosts.surface_sum[g] < T(0.5)) continue;
    find_contact_point(owner, ghosts, static_cast<std::int32_t>(g), opposing);
  }
  contact_points.traction.resize(contact_points.ghost.size());
}

// Whether the ghost's foot point, which has moved about as far as the ghost, may lie on another
// body.
template <class T, int D>
bool ContactSearch<T, D>::may_be_in_contact(int owner, const BlockGhosts<T, D>& ghosts,
                                            std::int32_t ghost) const {
  const Body<T, D>& body = state_.bodies[owner];
  Point<D> x = ghosts.foot[ghost];
  for (int a = 0; a < D; ++a) {
    x[a] += body.stage[0].get(Field::drift, a)[ghosts.slot[ghost]];
  }
  const auto& contacts = contacts_of_[owner];
  return std::any_of(contacts.begin(), contacts.end(), [&](int contact) {
    const int other = other_body(contact, owner);
    const Lattice<D>& lattice = state_.bodies[other].lattice;
    return surfaces_[other].is_near_another &&
           surfaces_[other].holds(place<D>(x, lattice), lattice, contact_fit_radius);
  });
}

// The gap to consider [h]; `apart` if the ghost is not affected by the contact's other body. Level
// sets give wrong gaps at corners, such as the end of a tied interface; a tie therefore only
// compares which body is nearer.
template <class T, int D>
double ContactSearch<T, D>::contact_gap(int contact, int owner, const GhostPlace& ghost,
                                        OpposingFit<T, D>& opposing) const {
  const int other = other_body(contact, owner);
  if (!surfaces_[other].is_near_another) return apart;
  const auto gap = [&](const Point<D>& x, double farthest) {
    return opposing.gap(surfaces_[other], state_.bodies[other].lattice, x, farthest);
  };
  if (contacts_[contact].law == ContactLaw::tied) {
    return gap(ghost.position, apart) < ghost.distance ? gap(ghost.foot, apart) : apart;
  }
  const double at_foot = gap(ghost.foot, clearly_apart);
  return at_foot < pressed_gap ? at_foot : apart;
}

// A ghost's contact point is on the nearest body that its own body may touch.
template <class T, int D>
void ContactSearch<T, D>::find_contact_point(int owner, BlockGhosts<T, D>& ghosts,
                                             std::int32_t ghost,
                                             OpposingFit<T, D>& opposing) const {
  if (!may_be_in_contact(owner, ghosts, ghost)) return;
  const Body<T, D>& body = state_.bodies[owner];
  const double h = body.lattice.spacing;
  const std::int32_t slot = ghosts.slot[ghost];
  const GhostPlace place = {body.position(slot, body.population.layout.cell(slot)),
                            foot_point(body, ghosts, ghost),
                            body.stage[0].get(Field::level_set)[slot] / h};
  int nearest = -1;
  double least = apart;
  for (const int contact : contacts_of_[owner]) {
    const double gap = contact_gap(contact, owner, place, opposing);
    if (gap >= least) continue;
    least = gap;
    nearest = contact;
  }
  if (nearest < 0) return;
  // The opposing fit may be that of another body.
  if (nearest != contacts_of_[owner].back()) contact_gap(nearest, owner, place, opposing);
  if (!opposing.add_to(ghosts.contact_points)) return;
  ghosts.contact_points.ghost.push_back(ghost);
  ghosts.contact_points.contact.push_back(nearest);
  ghosts.contact_points.gap.push_back(static_cast<T>(least * h));
  ghosts.contact_points.area.push_back(
      static_cast<T>(std::pow(h, D - 1) * surface_share<D>(place.distance)));
}

// The foot point moves with the particles of its fit.
template <class T, int D>
Point<D> ContactSearch<T, D>::foot_point(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                         std::int32_t ghost) const {
  Point<D> x = ghosts.foot[ghost];
  for (int a = 0; a < D; ++a) {
    const T* drift = body.stage[0].get(Field::drift, a);
    for (std::int64_t k = ghosts.begin[ghost]; k < ghosts.begin[ghost + 1]; ++k) {
      x[a] += fit_coefficient<T, D>(ghosts, ghost, k, ghosts.terms[ghost].surface) *
              drift[body.population.slot_of_record[kernels::record_of(ghosts.pairs[k])]];
    }
  }
  return x;
}

template class ContactSearch<double, 2>;
template class ContactSearch<double, 3>;
template class ContactSearch<float, 2>;
template class ContactSearch<float, 3>;

}  // namespace pliant::remeshed
