#include "engine/remeshed/contact/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/contact/opposing_fit.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "engine/remeshed/ghosts/present_foot.hpp"
#include "engine/remeshed/state/resources.hpp"

namespace pliant::remeshed {

namespace {

// Largest gap of surfaces that pushed each other before [h]. If noise of phi opened a pressed
// surface for a few steps, the bodies would hit each other and lose that energy.
constexpr double leaving_gap = 0.1;
constexpr double beside_face = 0.1;  // [h], less deep a foot point lies on the face
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
      sampler_(state, contacts) {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    for (const int body : contacts_[c].bodies) contacts_of_[body].push_back(static_cast<int>(c));
  }
}

template <class T, int D>
void ContactSearch<T, D>::add_phases(std::vector<scheduler::Phase>& phases) {
  using namespace resource;
  using enum Group;
  sampler_.add_phases(phases);
  PhaseRows(phases).each("contact search: points",
                         all(whole(surface_cells)) + near(particles(drift) + whole(fits)) +
                             own(ghosts(drift) + ghosts(constants)),
                         own(whole(contact_points) + whole(tractions)),
                         [this](int block) { find_contact_points(block); });
}

template <class T, int D>
void ContactSearch<T, D>::find_contact_points(int block) {
  const auto [owner, local] = state_.blocks[block];
  BlockGhosts<T, D>& ghosts = state_.bodies[owner].population.ghosts[local];
  ContactPoints<T, D>& contact_points = ghosts.contact_points;
  contact_points.clear();
  directions_[block].clear();
  if (!surfaces()[owner].is_near_another) return;
  thread_local OpposingFit<T, D> opposing;
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    // Fits around a wall give no traction of the free surface.
    if (ghosts.wall[g] >= 0 || ghosts.surface_sum[g] < T(0.5)) continue;
    const auto ghost = static_cast<std::int32_t>(g);
    if (may_be_in_contact(owner, ghosts, ghost)) add_contact_point(block, ghost, opposing);
  }
  contact_points.traction.resize(contact_points.ghost.size());
}

// Whether the ghost's foot point, which has moved about as far as the ghost, may lie on another
// body.
template <class T, int D>
bool ContactSearch<T, D>::may_be_in_contact(int owner, const BlockGhosts<T, D>& ghosts,
                                            std::int32_t ghost) const {
  const Body<T, D>& body = state_.bodies[owner];
  const Point<D> x = present_foot(body, ghosts, static_cast<std::size_t>(ghost), 0);
  const auto& contacts = contacts_of_[owner];
  return std::any_of(contacts.begin(), contacts.end(), [&](int contact) {
    const int other = other_body(contact, owner);
    const SurfaceSamples<D>& surface = surfaces()[other];
    const Lattice<D>& lattice = state_.bodies[other].lattice;
    const Point<D> at = place<D>(x, lattice);
    return surface.is_near_another && surface.holds(at, lattice, contact_fit_radius) &&
           surface.cells.any_near(at, [&](const auto& site, const Point<D>&) {
             return surface.record[site.label] >= 0;
           });
  });
}

// The effect of a contact on a ghost. Level sets give wrong gaps at corners, such as the end of a
// tied interface; a tie therefore only compares which body is nearer.
template <class T, int D>
auto ContactSearch<T, D>::look(int contact, int owner, const GhostPlace& ghost,
                               OpposingFit<T, D>& opposing) const -> Found {
  const int other = other_body(contact, owner);
  Found found{contact, apart, ghost.foot, {}};
  if (!surfaces()[other].is_near_another) return found;
  const double h = state_.bodies[owner].lattice.spacing;
  if (contacts_[contact].law == ContactLaw::tied) {
    const auto gap = [&](const Point<D>& x) {
      return opposing.gap(surfaces()[other], state_.bodies[other].lattice, x);
    };
    if (gap(ghost.position) < ghost.distance) found.gap = h * gap(ghost.foot);
    return found;
  }
  FacingSurfaces<D> faces;
  if (!find_faces(owner, other, found.place, faces) || faces.cover == 0) return found;
  if (faces.gap < leaving_gap * h) found.gap = faces.gap;
  found.direction = {faces.normal, faces.cover, {}};
  return found;
}

// Beside an edge the foot point lies on a side, above the face in contact: x moves to that face.
template <class T, int D>
bool ContactSearch<T, D>::find_faces(int owner, int other, Point<D>& x,
                                     FacingSurfaces<D>& faces) const {
  thread_local FacingSearch<D> search;
  const Body<T, D>&own = state_.bodies[owner], &opposing = state_.bodies[other];
  const auto find = [&] {
    return search.find({surfaces()[owner], own.lattice}, {surfaces()[other], opposing.lattice}, x,
                       faces);
  };
  if (!find()) return false;
  if (std::abs(faces.depth) < beside_face * own.lattice.spacing) return true;
  for (int a = 0; a < D; ++a) x[a] += faces.depth * faces.normal[a];
  return find();
}

// A ghost's contact point is on the nearest body that its own body may touch.
template <class T, int D>
void ContactSearch<T, D>::add_contact_point(int block, std::int32_t ghost,
                                            OpposingFit<T, D>& opposing) {
  const auto [owner, local] = state_.blocks[block];
  Body<T, D>& body = state_.bodies[owner];
  BlockGhosts<T, D>& ghosts = body.population.ghosts[local];
  const double h = body.lattice.spacing;
  const std::int32_t slot = ghosts.slot[ghost];
  const FieldStore<T, D>& start = body.stage[0];
  // The foot point moves with the particles of its fit.
  const Point<D> moved = at_foot(
      body, ghosts, ghost, [&](std::int64_t p, int a) { return start.get(Field::drift, a)[p]; });
  Point<D> foot = ghosts.foot[ghost];
  for (int a = 0; a < D; ++a) foot[a] += moved[a];
  const GhostPlace place = {body.position(slot, body.population.layout.cell(slot)), foot,
                            start.get(Field::level_set)[slot] / h};
  Found nearest{-1, apart, {}, {}};
  for (const int contact : contacts_of_[owner]) {
    const Found found = look(contact, owner, place, opposing);
    if (found.gap < nearest.gap) nearest = found;
  }
  if (nearest.contact < 0) return;
  const int other = other_body(nearest.contact, owner);
  ContactPoints<T, D>& points = ghosts.contact_points;
  const auto displacement =
      opposing.add_to(points, surfaces()[other], state_.bodies[other].lattice, nearest.place);
  if (!displacement) return;
  if (contacts_[nearest.contact].law == ContactLaw::tied) {
    const Point<D> before = at_foot(body, ghosts, ghost, [&](std::int64_t p, int a) {
      return start.get(Field::displacement, a)[p];
    });
    for (int a = 0; a < D; ++a) {
      nearest.direction.parted[a] = (*displacement)[a] - before[a] - moved[a];
    }
  }
  directions_[block].push_back(nearest.direction);
  points.ghost.push_back(ghost);
  points.contact.push_back(nearest.contact);
  points.gap.push_back(static_cast<T>(nearest.gap));
  points.area.push_back(static_cast<T>(std::pow(h, D - 1) * surface_share<D>(place.distance)));
}

template <class T, int D>
template <class F>
Point<D> ContactSearch<T, D>::at_foot(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                      std::int32_t ghost, F&& value) const {
  Point<D> sum = {};
  for (int a = 0; a < D; ++a) {
    for (std::int64_t k = ghosts.begin[ghost]; k < ghosts.begin[ghost + 1]; ++k) {
      sum[a] += fit_coefficient<T, D>(ghosts, ghost, k, ghosts.terms[ghost].surface) *
                value(body.population.slot_of_record[kernels::record_of(ghosts.pairs[k])], a);
    }
  }
  return sum;
}

template class ContactSearch<double, 2>;
template class ContactSearch<double, 3>;
template class ContactSearch<float, 2>;
template class ContactSearch<float, 3>;

}  // namespace pliant::remeshed
