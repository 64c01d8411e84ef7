#include "engine/remeshed/ghosts/ghost_fitter.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "engine/lattice/column.hpp"
#include "engine/remeshed/ghosts/lasting_correction.hpp"
#include "engine/remeshed/ghosts/overhung_wall.hpp"
#include "engine/remeshed/ghosts/rim_ghosts.hpp"
#include "engine/storage/push_tightly.hpp"
#include "kernels/remeshed/ghosts/fit_coefficients.hpp"

namespace pliant::remeshed {

namespace {

constexpr double fit_radius = 2.6;   // [h], of (RP.43)
constexpr double mean_radius = 2.5;  // [h], of (RP.49)
constexpr double widening = 1.3;
constexpr int most_widenings = 5;
// Factor by which fits near a contact wall reach less far along the surface than into the body. The
// support of the body ends at the edge of contact. A fit across this edge mistakes the change there
// for a jump at the surface, which (RP.50) and (RP.51) damp.
constexpr double narrowing = 1.5;

// Within this distance from a no-slip wall or a re-entrant corner [h], (RP.50) does nothing. Along
// walls that cut the lattice at an angle, particles beside the corner are unstable with less
// than 2.4. Bodies that take 0.42 of (RP.50), (RP.83), are not stable there with either, and lose
// more energy with 2.4.
template <class T, int D>
double rim_reach(const Body<T, D>& body, const Boundaries<D>& boundaries) {
  return removes_lasting_correction(body, boundaries) ? 2.4 : 1;
}

// The share of the fit (RP.44) with its last term. That term also extrapolates the stresses that
// alternate from row to row beneath the surface of a body at rest. What a ghost then has in excess
// of minus the stress of the row beneath the surface is a force: it holds slender beams straight,
// docs/decisions/0068.
template <class T, int D>
double share_of_curved_fit(const Body<T, D>& body) {
  return body.bears_loads ? 0.7 : 1;
}

}  // namespace

template <class T, int D>
GhostFitter<T, D>::GhostFitter(const Body<T, D>& body, const Population<T, D>& population,
                               BlockGhosts<T, D>& ghosts, const LevelSet<T, D>& level_set,
                               const Boundaries<D>& boundaries, const ReentrantCorners<D>& corners,
                               const kernels::RemeshedTable<T, D>& table, std::int32_t* used)
    : body_(body),
      ghosts_(ghosts),
      search_(body.lattice, population, level_set),
      level_set_(level_set),
      boundaries_(boundaries),
      corners_(corners),
      rim_reach_(rim_reach(body, boundaries)),
      kernels_(table),
      used_(used) {}

template <class T, int D>
typename GhostFitter<T, D>::Scratch& GhostFitter<T, D>::scratch() {
  thread_local Scratch scratch;
  return scratch;
}

template <class T, int D>
void GhostFitter<T, D>::fit(const FitSite<D>& site, const Point<D>& foot, const Wall<D>* wall,
                            bool at_edge) {
  const double h = body_.lattice.spacing;
  const double wall_distance = boundaries_.distance_to_no_slip(foot) / h;
  double corner_distance = corners_.distance(foot) / h;
  if (wall == nullptr) {
    const double to_overhung =
        distance_to_overhung_wall<T, D>(boundaries_, level_set_, h, foot, as_point<D>(site.normal));
    corner_distance = std::min(corner_distance, to_overhung / h);
  }
  Waiting& ghost = scratch_.waiting[waiting_++];
  ghost.site = site;
  ghost.wall = wall;
  // The curved fit overshoots where the solution is singular: where walls that hold the body meet
  // the free surface, and at re-entrant corners. A slip wall is a plane of symmetry, without a
  // corner unless the surface leans over it.
  const bool is_curved = wall == nullptr
                             ? wall_distance > fit_radius && corner_distance > corner_reach
                             : has_curved_fit(*wall, foot);
  ghost.curved = is_curved ? share_of_curved_fit(body_) : 0;
  ghost.at_rim = wall == nullptr && (wall_distance < rim_reach_ || corner_distance < corner_reach);
  for (int a = 0; a < D; ++a) {
    ghost.centre[a] = (foot[a] - body_.lattice.origin[a]) / h - 0.5;
  }
  ghost.reach = {fit_radius, site.normal};
  ghost.near_contact = !at_edge && boundaries_.nearest_contact(foot).second < fit_radius * h;
  if (ghost.near_contact) ghost.reach.narrowing = narrowing;
  search_.find(ghost.centre, ghost.reach, wall, ghost.particles);
  if (waiting_ == pack) finish();
}

// Lasting loads curve the displacement over the distance from a wall.
template <class T, int D>
bool GhostFitter<T, D>::has_curved_fit(const Wall<D>& wall, const Point<D>& foot) const {
  return body_.bears_loads && wall.is_attached() && std::isinf(wall.friction()) &&
         level_set_.phi_at(foot) < -fit_radius * body_.lattice.spacing;
}

template <class T, int D>
void GhostFitter<T, D>::finish() {
  if (waiting_ == 0) return;
  std::size_t length = 0;
  for (int l = 0; l < waiting_; ++l) {
    length = std::max(length, scratch_.waiting[l].particles.size());
  }
  fill_lanes(static_cast<int>(length));
  fit_lanes(static_cast<int>(length));
  const Lanes& lanes = scratch_.lanes;
  for (int l = 0; l < waiting_; ++l) {
    Waiting& ghost = scratch_.waiting[l];
    if (ghost.near_contact || lanes.fitted[l] == 0 || ghost.amplifies(lanes.constrained_sum[l])) {
      fit_alone(ghost);
      continue;
    }
    Terms terms = terms_of_lane(l);
    place(ghost, terms);
    append(ghost, terms, lanes.constrained_sum[l]);
  }
  waiting_ = 0;
}

template <class T, int D>
void GhostFitter<T, D>::fill_lanes(int length) {
  Lanes& lanes = scratch_.lanes;
  const std::size_t entries = static_cast<std::size_t>(length) * pack;
  for (auto& coordinate : lanes.position) coordinate.resize(entries);
  lanes.distance.resize(entries);
  // Lanes without a ghost repeat the first one.
  for (int l = 0; l < pack; ++l) fill_lane(l, length);
}

template <class T, int D>
void GhostFitter<T, D>::fill_lane(int lane, int length) {
  Lanes& lanes = scratch_.lanes;
  const Waiting& ghost = scratch_.waiting[lane < waiting_ ? lane : 0];
  const int count = static_cast<int>(ghost.particles.size());
  for (int k = 0, entry = lane; k < count; ++k, entry += pack) {
    const FitParticle<D>& particle = ghost.particles[k];
    for (int a = 0; a < D; ++a) lanes.position[a][entry] = particle.position[a];
    lanes.distance[entry] = particle.surface_distance;
  }
  for (int k = count, entry = lane + count * pack; k < length; ++k, entry += pack) {
    for (int a = 0; a < D; ++a) lanes.position[a][entry] = 2 * fit_radius;
    lanes.distance[entry] = 0;
  }
  for (int a = 0; a < D; ++a) {
    lanes.ghost[a][lane] = ghost.site.ghost[a];
    lanes.normal[a][lane] = ghost.site.normal[a];
  }
  lanes.ghost_distance[lane] = ghost.site.surface_distance;
  lanes.curved[lane] = static_cast<T>(ghost.curved);
}

template <class T, int D>
void GhostFitter<T, D>::fit_lanes(int length) {
  Lanes& lanes = scratch_.lanes;
  kernels::SurfaceFits<T, D> work = {};
  work.length = length;
  work.radius = fit_radius;
  for (int a = 0; a < D; ++a) {
    work.position[a] = lanes.position[a].data();
    work.ghost[a] = lanes.ghost[a].data();
    work.normal[a] = lanes.normal[a].data();
  }
  work.distance = lanes.distance.data();
  work.ghost_distance = lanes.ghost_distance.data();
  work.curved = lanes.curved.data();
  work.fitted = lanes.fitted.data();
  work.constrained_sum = lanes.constrained_sum.data();
  for (std::size_t i = 0; i < work.linear.size(); ++i) {
    work.linear[i] = lanes.linear[i].data();
    work.surface[i] = lanes.surface[i].data();
  }
  for (std::size_t i = 0; i < work.constrained.size(); ++i) {
    work.constrained[i] = lanes.constrained[i].data();
  }
  kernels_.fit_surface(work);
}

template <class T, int D>
typename GhostFitter<T, D>::Terms GhostFitter<T, D>::terms_of_lane(int lane) const {
  const Lanes& lanes = scratch_.lanes;
  Terms terms;
  for (std::size_t i = 0; i < terms.linear.size(); ++i) {
    terms.linear[i] = lanes.linear[i][lane];
    terms.surface[i] = lanes.surface[i][lane];
  }
  for (std::size_t i = 0; i < terms.constrained.size(); ++i) {
    terms.constrained[i] = lanes.constrained[i][lane];
  }
  return terms;
}

template <class T, int D>
void GhostFitter<T, D>::fit_alone(Waiting& ghost) {
  Terms terms;
  bool fitted = fit_fully(ghost, terms);
  for (int attempt = 0; !fitted && attempt < most_widenings; ++attempt) {
    ghost.reach.radius *= widening;
    search_.find(ghost.centre, ghost.reach, ghost.wall, ghost.particles);
    fitted = fit_fully(ghost, terms);
  }
  if (!fitted) fit_poorly(ghost, terms);
  place(ghost, terms);
  T sum = 0;
  for (const FitParticle<D>& i : ghost.particles) {
    T r[D];
    for (int a = 0; a < D; ++a) r[a] = static_cast<T>(i.position[a]);
    sum += kernels::fit_coefficients(terms, r, static_cast<T>(i.surface_distance)).constrained;
  }
  if (ghost.amplifies(sum)) {
    ghost.curved = 0;
    return fit_alone(ghost);
  }
  append(ghost, terms, sum);
}

template <class T, int D>
bool GhostFitter<T, D>::fit_fully(const Waiting& ghost, Terms& terms) const {
  return fit_in_all_directions(ghost.particles, ghost.site, terms) &&
         fit_constrained(ghost.particles, ghost.site, ghost.curved, terms);
}

template <class T, int D>
void GhostFitter<T, D>::fit_poorly(const Waiting& ghost, Terms& terms) const {
  terms = {};
  if (!fit_along_normal(ghost.particles, ghost.site, terms)) {
    double sum = 0;
    for (const FitParticle<D>& i : ghost.particles) sum += i.weight;
    terms.linear[0] = terms.surface[0] = static_cast<T>(1 / sum);
  }
  fit_proportional(ghost.particles, ghost.site, terms);
}

template <class T, int D>
void GhostFitter<T, D>::average(const Cell<D>& cell) {
  Waiting& ghost = scratch_.waiting[0];
  ghost.wall = nullptr;
  ghost.at_rim = false;
  for (int a = 0; a < D; ++a) ghost.centre[a] = cell[a];
  ghost.reach = {mean_radius};
  search_.find(ghost.centre, ghost.reach, nullptr, ghost.particles);
  for (int attempt = 0; ghost.particles.empty() && attempt < 2 * most_widenings; ++attempt) {
    ghost.reach.radius *= widening;
    search_.find(ghost.centre, ghost.reach, nullptr, ghost.particles);
  }
  ghost.reach.radius = std::numeric_limits<double>::infinity();  // all particles have equal weights
  Terms mean;
  mean.linear[0] = mean.surface[0] = T(1) / static_cast<T>(ghost.particles.size());
  place(ghost, mean);
  append(ghost, mean, 0);
}

// Sets the weight of (RP.43), and the cell next to the foot point as the origin of particle
// offsets. At rims the traction that the fit finds is the singular stress, not an outgoing wave.
template <class T, int D>
void GhostFitter<T, D>::place(const Waiting& ghost, Terms& terms) {
  if (ghost.at_rim) terms.surface = {};
  const Position<D> broad = ghost.reach.broad();
  terms.steepness = static_cast<T>(ghost.reach.steepness());
  for (int a = 0; a < D; ++a) {
    terms.broad[a] = static_cast<T>(broad[a]);
    terms.start[a] = static_cast<T>(nearest_cell(ghost.centre[a]) - ghost.centre[a]);
  }
}

template <class T, int D>
void GhostFitter<T, D>::append(const Waiting& ghost, const Terms& terms, T constrained_sum) {
  push_tightly(ghosts_.terms, terms);
  push_tightly(ghosts_.constrained_sum, constrained_sum);
  push_tightly(ghosts_.surface_sum, ghost.at_rim || ghost.particles.empty() ? T(0) : T(1));
  if (ghost.at_rim && body_.bears_loads) {
    Point<D> foot;
    for (int a = 0; a < D; ++a) {
      foot[a] = body_.lattice.origin[a] + (ghost.centre[a] + 0.5) * body_.lattice.spacing;
    }
    const auto number = static_cast<std::int32_t>(ghosts_.terms.size() - 1);
    list_at_rim<T, D>({number, foot, ghost.site, ghost.particles, terms}, body_.lattice, level_set_,
                      boundaries_, ghosts_);
  }
  const auto wall_begin = static_cast<std::int64_t>(ghosts_.wall_distance.size());
  push_tightly(ghosts_.wall_begin, ghost.wall == nullptr ? std::int64_t{-1} : wall_begin);
  for (const FitParticle<D>& i : ghost.particles) {
    Cell<D> cells;
    for (int a = 0; a < D; ++a) {
      cells[a] = nearest_cell(i.position[a] - terms.start[a]);
    }
    push_tightly(ghosts_.pairs, kernels::fit_pair<D>(i.slot, cells));
    if (ghost.wall != nullptr) {
      push_tightly(ghosts_.wall_distance, static_cast<T>(i.surface_distance));
    }
    // Several blocks may mark the same particle at once; they all write 1.
    std::atomic_ref<std::int32_t>(used_[i.slot]).store(1, std::memory_order_relaxed);
  }
  push_tightly(ghosts_.begin, static_cast<std::int64_t>(ghosts_.pairs.size()));
}

template class GhostFitter<double, 2>;
template class GhostFitter<double, 3>;
template class GhostFitter<float, 2>;
template class GhostFitter<float, 3>;

}  // namespace pliant::remeshed
