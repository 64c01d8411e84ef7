#include "engine/remeshed/ghost_fitter.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace pliant::remeshed {

namespace {

constexpr double fit_radius = 2.6;   // [h], of (RP.32)
constexpr double mean_radius = 2.5;  // [h], of (RP.38)
constexpr double widening = 1.3;
constexpr int most_widenings = 5;
// How much less far fits look along the surface than into the body near a contact wall: what holds
// the body ends at the edge of contact, and a fit that looks across it takes what it sees there for
// a jump at the surface, which (RP.44) and (RP.45) damp.
constexpr double narrowing = 1.5;

// Pairs of ghosts and particles are many: their lists grow by an eighth, not to the double.
template <class V>
void grow(std::vector<V>& list, std::size_t size) {
  if (size > list.capacity()) list.reserve(size + size / 8);
  list.resize(size);
}

}  // namespace

template <class T, int D>
GhostFitter<T, D>::GhostFitter(const Body<T, D>& body, const Population<T, D>& population,
                               BlockGhosts<T, D>& ghosts, const LevelSet<T, D>& level_set,
                               const Boundaries<D>& boundaries, const kernels::Table<T, D>& table,
                               std::int32_t* used)
    : body_(body),
      population_(population),
      ghosts_(ghosts),
      level_set_(level_set),
      boundaries_(boundaries),
      kernels_(table),
      used_(used) {}

template <class T, int D>
typename GhostFitter<T, D>::Scratch& GhostFitter<T, D>::scratch() {
  thread_local Scratch scratch;
  return scratch;
}

template <class T, int D>
void GhostFitter<T, D>::fit(const FitSite<D>& site, const Point<D>& foot, const Wall<D>* wall) {
  const double h = body_.lattice.spacing;
  const double corner_distance = boundaries_.distance_to_sticking(foot) / h;
  Waiting& ghost = scratch_.waiting[waiting_++];
  ghost.site = site;
  ghost.wall = wall;
  // The curved fit overshoots where the solution is singular: at walls that hold the body, and
  // where they meet the free surface. A slip wall is a plane of symmetry, which makes no corner.
  ghost.curved = wall == nullptr && corner_distance > fit_radius;
  ghost.at_rim = wall == nullptr && corner_distance < 1;
  for (int a = 0; a < D; ++a) {
    ghost.centre[a] = (foot[a] - body_.lattice.origin[a]) / h - 0.5;
  }
  ghost.reach = {fit_radius, site.normal};
  ghost.near_contact = boundaries_.nearest_contact(foot).second < fit_radius * h;
  if (ghost.near_contact) ghost.reach.narrowing = narrowing;
  search(ghost.centre, ghost.reach, wall, ghost.particles);
  if (waiting_ == pack) finish();
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
    if (ghost.at_rim || ghost.near_contact || lanes.fitted[l] == 0) {
      fit_alone(ghost);
      continue;
    }
    ghosts_.constrained_sum.push_back(lanes.constrained_sum[l]);
    ghosts_.surface_sum.push_back(lanes.surface_sum[l]);
    append(ghost.particles, lanes.linear.data() + l, lanes.constrained.data() + l,
           lanes.surface.data() + l, pack);
  }
  waiting_ = 0;
}

template <class T, int D>
void GhostFitter<T, D>::fill_lanes(int length) {
  Lanes& lanes = scratch_.lanes;
  const std::size_t entries = static_cast<std::size_t>(length) * pack;
  for (auto& coordinate : lanes.position) coordinate.resize(entries);
  for (auto* list : {&lanes.distance, &lanes.linear, &lanes.constrained, &lanes.surface}) {
    list->resize(entries);
  }
  // Lanes without a ghost repeat the first.
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
  lanes.curved[lane] = ghost.curved ? 1 : 0;
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
  work.linear = lanes.linear.data();
  work.constrained = lanes.constrained.data();
  work.surface = lanes.surface.data();
  work.constrained_sum = lanes.constrained_sum.data();
  work.surface_sum = lanes.surface_sum.data();
  work.fitted = lanes.fitted.data();
  kernels_.fit_surface(work);
}

template <class T, int D>
void GhostFitter<T, D>::fit_alone(Waiting& ghost) {
  bool fitted = fit_fully(ghost);
  for (int attempt = 0; !fitted && attempt < most_widenings; ++attempt) {
    ghost.reach.radius *= widening;
    search(ghost.centre, ghost.reach, ghost.wall, ghost.particles);
    fitted = fit_fully(ghost);
  }
  if (!fitted) fit_poorly(ghost);
  // What the fit finds as traction there is the singular stress, no wave to let out.
  if (ghost.at_rim) std::fill(scratch_.surface.begin(), scratch_.surface.end(), 0);
  keep(ghost.particles);
}

template <class T, int D>
bool GhostFitter<T, D>::fit_fully(const Waiting& ghost) {
  clear();
  return fit_in_all_directions<D>(ghost.particles, ghost.site, scratch_.linear, scratch_.surface) &&
         fit_constrained<D>(ghost.particles, ghost.site, ghost.curved, scratch_.constrained);
}

template <class T, int D>
void GhostFitter<T, D>::fit_poorly(const Waiting& ghost) {
  clear();
  if (!fit_along_normal<D>(ghost.particles, ghost.site, scratch_.linear, scratch_.surface)) {
    take_mean(ghost.particles);
  }
  if (!fit_proportional<D>(ghost.particles, ghost.site, scratch_.constrained)) {
    scratch_.constrained.assign(ghost.particles.size(), 0);
  }
}

template <class T, int D>
void GhostFitter<T, D>::clear() {
  scratch_.linear.clear();
  scratch_.constrained.clear();
  scratch_.surface.clear();
}

template <class T, int D>
void GhostFitter<T, D>::take_mean(const FitParticles<D>& particles) {
  double sum = 0;
  for (const FitParticle<D>& i : particles) sum += i.weight;
  scratch_.linear.clear();
  for (const FitParticle<D>& i : particles) scratch_.linear.push_back(i.weight / sum);
  scratch_.surface = scratch_.linear;
}

template <class T, int D>
void GhostFitter<T, D>::average(const Cell<D>& cell) {
  FitParticles<D>& particles = scratch_.waiting[0].particles;
  Point<D> centre;
  for (int a = 0; a < D; ++a) centre[a] = cell[a];
  FitReach<D> reach = {mean_radius};
  search(centre, reach, nullptr, particles);
  for (int attempt = 0; particles.empty() && attempt < 2 * most_widenings; ++attempt) {
    reach.radius *= widening;
    search(centre, reach, nullptr, particles);
  }
  scratch_.linear.assign(particles.size(), particles.empty() ? 0 : 1.0 / particles.size());
  scratch_.constrained.assign(particles.size(), 0);
  scratch_.surface = scratch_.linear;
  keep(particles);
}

// What was fitted for one ghost alone.
template <class T, int D>
void GhostFitter<T, D>::keep(const FitParticles<D>& particles) {
  const auto sum = [](const std::vector<double>& list) {
    return static_cast<T>(std::accumulate(list.begin(), list.end(), 0.));
  };
  ghosts_.constrained_sum.push_back(sum(scratch_.constrained));
  ghosts_.surface_sum.push_back(sum(scratch_.surface));
  append(particles, scratch_.linear.data(), scratch_.constrained.data(), scratch_.surface.data(),
         1);
}

template <class T, int D>
template <class V>
void GhostFitter<T, D>::append(const FitParticles<D>& particles, const V* linear,
                               const V* constrained, const V* surface, int stride) {
  const std::size_t first = ghosts_.record.size(), pairs = first + particles.size();
  grow(ghosts_.record, pairs);
  grow(ghosts_.linear, pairs);
  grow(ghosts_.constrained, pairs);
  grow(ghosts_.surface, pairs);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    ghosts_.record[first + k] = particles[k].slot;
    ghosts_.linear[first + k] = static_cast<T>(linear[stride * k]);
    ghosts_.constrained[first + k] = static_cast<T>(constrained[stride * k]);
    ghosts_.surface[first + k] = static_cast<T>(surface[stride * k]);
    // Several blocks may mark the same particle at once; they all write 1.
    std::atomic_ref<std::int32_t>(used_[particles[k].slot]).store(1, std::memory_order_relaxed);
  }
  ghosts_.begin.push_back(static_cast<std::int64_t>(pairs));
}

// Interior particles within reach of a point given in cells.
template <class T, int D>
void GhostFitter<T, D>::search(const Point<D>& centre, const FitReach<D>& reach,
                               const Wall<D>* wall, FitParticles<D>& particles) const {
  particles.clear();
  const double radius = reach.radius;
  Cell<D> lower, upper;
  for (int a = 0; a < D; ++a) {
    lower[a] = static_cast<std::int32_t>(std::ceil(centre[a] - radius));
    upper[a] = static_cast<std::int32_t>(std::floor(centre[a] + radius));
  }
  Cell<D> cell = lower;
  const auto scan_row = [&] {
    double square = radius * radius;
    for (int a = 1; a < D; ++a) square -= (cell[a] - centre[a]) * (cell[a] - centre[a]);
    if (square <= 0) return;
    const double chord = std::sqrt(square);
    cell[0] = static_cast<std::int32_t>(std::ceil(centre[0] - chord));
    const auto last = static_cast<std::int32_t>(std::floor(centre[0] + chord));
    // One look-up serves a row that lies in one run.
    std::int64_t slot =
        body_.lattice.is_periodic() ? -1 : population_.layout.slot(cell, last + 1 - cell[0]);
    const bool in_one_run = slot >= 0;
    for (; cell[0] <= last; ++cell[0], ++slot) {
      if (!in_one_run) slot = population_.layout.slot(body_.lattice.wrapped(cell));
      if (slot >= 0) consider(slot, cell, centre, reach, wall, particles);
    }
  };
  if constexpr (D == 2) {
    for (cell[1] = lower[1]; cell[1] <= upper[1]; ++cell[1]) scan_row();
  } else {
    for (cell[2] = lower[2]; cell[2] <= upper[2]; ++cell[2]) {
      for (cell[1] = lower[1]; cell[1] <= upper[1]; ++cell[1]) scan_row();
    }
  }
}

template <class T, int D>
void GhostFitter<T, D>::consider(std::int64_t slot, const Cell<D>& cell, const Point<D>& centre,
                                 const FitReach<D>& reach, const Wall<D>* wall,
                                 FitParticles<D>& particles) const {
  if (population_.kind[slot] != Kind::interior) return;
  Position<D> r;
  for (int a = 0; a < D; ++a) r[a] = cell[a] - centre[a];
  const double fraction = reach.fraction(r);
  if (fraction >= 1) return;
  const double distance =
      wall ? wall->distance(body_.lattice.node(cell)) : level_set_.surface_distance(slot);
  particles.push_back({static_cast<std::int32_t>(slot), (1 - fraction) * (1 - fraction),
                       distance / body_.lattice.spacing, r});
}

template class GhostFitter<double, 2>;
template class GhostFitter<double, 3>;

}  // namespace pliant::remeshed
