#include "engine/remeshed/ghost_fits.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "engine/remeshed/surface_fits.hpp"

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
void make_room(std::vector<V>& list, std::size_t size) {
  if (size > list.capacity()) list.reserve(size + size / 8);
}

template <class T, int D>
class GhostFitter {
 public:
  GhostFitter(const Body<T, D>& body, Population<T, D>& population, const FieldStore<T, D>& state,
              int block, const LevelSet<T, D>& level_set, const Boundaries<D>& boundaries,
              GhostTreatment treatment, std::int32_t* used)
      : body_(body),
        population_(population),
        phi_(state.get(Field::level_set)),
        level_set_(level_set),
        ghosts_(population.ghosts[block]),
        boundaries_(boundaries),
        treatment_(treatment),
        used_(used) {}

  void add(std::int64_t slot, const Cell<D>& cell) {
    const Point<D> x = body_.lattice.node(cell);
    if (population_.kind[slot] == Kind::wall_ghost) {
      const auto [wall, distance] = boundaries_.nearest_wall(x);
      add(slot, cell, wall, distance);
      return;
    }
    add(slot, cell, -1, 0);
    const auto [wall, distance] = boundaries_.nearest_contact(x);
    const double height = surface_distance(slot) + distance;
    // The body comes no nearer than this before the next remeshing.
    if (distance < 0 && height < body_.lattice.spacing) add_contact(slot, cell, wall, height);
  }

 private:
  void add_contact(std::int64_t slot, const Cell<D>& cell, int wall, double height) {
    const double h = body_.lattice.spacing;
    const double distance = boundaries_.walls[wall].distance(body_.lattice.node(cell));
    ghosts_.contact.push_back(static_cast<std::int32_t>(ghosts_.slot.size()));
    add(slot, cell, wall, distance);
    ghosts_.active.back() = touched(cell);
    const Point<D>& normal = ghosts_.normal.back();
    for (int a = 0; a < D; ++a) height += normal[a] * boundaries_.walls[wall].offset()[a];
    ghosts_.contact_height.push_back(height);
    ghosts_.contact_area.push_back(std::pow(h, D - 1) *
                                   std::max(0., 1 - std::abs(distance / h + 1)));
  }

  // What was decided for a slot before this remeshing, (RP.50).
  bool touched(const Cell<D>& cell) const {
    const Population<T, D>& before = body_.population;
    if (before.layout.blocks().empty()) return false;
    const std::int64_t slot = before.layout.slot(cell);
    return slot >= 0 && before.kind[slot] == Kind::wall_ghost;
  }

  void add(std::int64_t slot, const Cell<D>& cell, int wall, double wall_distance) {
    const double h = body_.lattice.spacing;
    const Point<D> x = body_.lattice.node(cell);
    const bool at_wall = wall >= 0;
    Point<D> normal = {}, foot = x;
    if (at_wall) {
      normal = boundaries_.walls[wall].normal(x);
      for (int a = 0; a < D; ++a) foot[a] -= wall_distance * normal[a];
    } else {
      Point<D> offset = {};
      level_set_.closest_point(slot, offset);
      for (int a = 0; a < D; ++a) foot[a] += offset[a];
      // Where the surface runs on behind a wall, fits are made about the wall.
      const auto [foot_wall, depth] = boundaries_.nearest_wall(foot);
      if (depth < 0) {
        const Point<D> out = boundaries_.walls[foot_wall].normal(foot);
        for (int a = 0; a < D; ++a) foot[a] -= depth * out[a];
      }
    }
    FitSite<D> site;
    for (int a = 0; a < D; ++a) {
      site.ghost[a] = (x[a] - foot[a]) / h;
      site.normal[a] = at_wall ? normal[a] : site.ghost[a];
    }
    if (!at_wall) site.normal = site.normal.norm() > 1e-9 ? site.normal.normalized() : site.normal;
    site.surface_distance = (at_wall ? wall_distance : surface_distance(slot)) / h;

    ghosts_.slot.push_back(static_cast<std::int32_t>(slot));
    ghosts_.wall.push_back(static_cast<std::int8_t>(at_wall ? wall : -1));
    ghosts_.active.push_back(1);
    ghosts_.pressure.push_back(at_wall ? std::int8_t{-1} : pressure_at(foot));
    ghosts_.normal.push_back(normal);
    ghosts_.foot.push_back(foot);
    if (treatment_ == GhostTreatment::averaged) {
      average(cell);
    } else {
      fit(site, foot, at_wall ? &boundaries_.walls[wall] : nullptr);
    }
    ghosts_.begin.push_back(static_cast<std::int64_t>(ghosts_.neighbour.size()));
  }

  // phi is a distance only after a reinitialisation; the closest point always tells.
  double surface_distance(std::int64_t slot) const {
    Point<D> offset;
    if (!level_set_.closest_point(slot, offset)) return phi_[slot];
    double square = 0;
    for (int a = 0; a < D; ++a) square += offset[a] * offset[a];
    return std::copysign(std::sqrt(square), phi_[slot]);
  }

  std::int8_t pressure_at(const Point<D>& foot) const {
    for (std::size_t i = 0; i < boundaries_.pressures.size(); ++i) {
      if (boundaries_.pressures[i].acts_at(foot)) return static_cast<std::int8_t>(i);
    }
    return -1;
  }

  // Interior particles within reach of a point given in cells.
  void search(const Point<D>& centre, const FitReach<D>& reach, const Wall<D>* wall) {
    particles_.clear();
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
      std::int64_t slot = body_.lattice.period == Cell<D>{}
                              ? population_.layout.slot(cell, last + 1 - cell[0])
                              : -1;
      const bool in_one_run = slot >= 0;
      for (; cell[0] <= last; ++cell[0], ++slot) {
        if (!in_one_run) slot = population_.layout.slot(body_.lattice.wrapped(cell));
        if (slot >= 0) consider(slot, cell, centre, reach, wall);
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

  void consider(std::int64_t q, const Cell<D>& cell, const Point<D>& centre,
                const FitReach<D>& reach, const Wall<D>* wall) {
    if (population_.kind[q] != Kind::interior) return;
    Position<D> r;
    for (int a = 0; a < D; ++a) r[a] = cell[a] - centre[a];
    const double fraction = reach.fraction(r);
    if (fraction >= 1) return;
    const double distance = wall ? wall->distance(body_.lattice.node(cell)) : surface_distance(q);
    particles_.push_back({static_cast<std::int32_t>(q), (1 - fraction) * (1 - fraction),
                          distance / body_.lattice.spacing, r});
  }

  void fit(const FitSite<D>& site, const Point<D>& foot, const Wall<D>* wall) {
    Point<D> centre;
    for (int a = 0; a < D; ++a) {
      centre[a] = (foot[a] - body_.lattice.origin[a]) / body_.lattice.spacing - 0.5;
    }
    // The curved fit overshoots where the solution is singular: at walls and where they meet the
    // free surface.
    const double wall_distance = boundaries_.nearest_wall(foot).second / body_.lattice.spacing;
    const bool curved = wall == nullptr && wall_distance > fit_radius;
    FitReach<D> reach = {fit_radius, site.normal};
    if (boundaries_.nearest_contact(foot).second < fit_radius * body_.lattice.spacing) {
      reach.narrowing = narrowing;
    }
    bool fitted = false;
    for (int attempt = 0; !fitted && attempt <= most_widenings; ++attempt) {
      search(centre, reach, wall);
      reach.radius *= widening;
      fitted = fit_fully(site, curved);
    }
    if (!fitted) fit_poorly(site);
    // What the fit finds as traction there is the singular stress, no wave to let out.
    if (wall == nullptr && wall_distance < 1) a_.assign(a_.size(), 0);
    keep();
  }

  bool fit_fully(const FitSite<D>& site, bool curved) {
    clear();
    return fit_in_all_directions<D>(particles_, site, c_, a_) &&
           fit_constrained<D>(particles_, site, curved, b_);
  }

  void fit_poorly(const FitSite<D>& site) {
    clear();
    if (!fit_along_normal<D>(particles_, site, c_, a_)) constant();
    if (!fit_proportional<D>(particles_, site, b_)) b_.assign(particles_.size(), 0);
  }

  void clear() {
    c_.clear();
    b_.clear();
    a_.clear();
  }

  void constant() {
    double sum = 0;
    for (const FitParticle<D>& i : particles_) sum += i.weight;
    c_.clear();
    for (const FitParticle<D>& i : particles_) c_.push_back(i.weight / sum);
    a_ = c_;
  }

  void average(const Cell<D>& cell) {
    Point<D> centre;
    for (int a = 0; a < D; ++a) centre[a] = cell[a];
    FitReach<D> reach = {mean_radius};
    search(centre, reach, nullptr);
    for (int attempt = 0; particles_.empty() && attempt < 2 * most_widenings; ++attempt) {
      reach.radius *= widening;
      search(centre, reach, nullptr);
    }
    c_.assign(particles_.size(), particles_.empty() ? 0 : 1.0 / particles_.size());
    b_.assign(particles_.size(), 0);
    a_ = c_;
    keep();
  }

  void keep() {
    ghosts_.constrained_sum.push_back(static_cast<T>(std::accumulate(b_.begin(), b_.end(), 0.)));
    ghosts_.surface_sum.push_back(static_cast<T>(std::accumulate(a_.begin(), a_.end(), 0.)));
    const std::size_t pairs = ghosts_.neighbour.size() + particles_.size();
    make_room(ghosts_.neighbour, pairs);
    for (auto* fit : {&ghosts_.linear, &ghosts_.constrained, &ghosts_.surface}) {
      make_room(*fit, pairs);
    }
    for (std::size_t k = 0; k < particles_.size(); ++k) {
      ghosts_.neighbour.push_back(particles_[k].slot);
      ghosts_.linear.push_back(static_cast<T>(c_[k]));
      ghosts_.constrained.push_back(static_cast<T>(b_[k]));
      ghosts_.surface.push_back(static_cast<T>(a_[k]));
      // Several blocks may mark the same particle at once; they all write 1.
      std::atomic_ref<std::int32_t>(used_[particles_[k].slot]).store(1, std::memory_order_relaxed);
    }
  }

  const Body<T, D>& body_;
  Population<T, D>& population_;
  const T* phi_;
  const LevelSet<T, D>& level_set_;
  BlockGhosts<T, D>& ghosts_;
  const Boundaries<D>& boundaries_;
  GhostTreatment treatment_;
  std::int32_t* used_;
  FitParticles<D>& particles_ = scratch().particles;
  std::vector<double>& c_ = scratch().c;
  std::vector<double>& b_ = scratch().b;
  std::vector<double>& a_ = scratch().a;

  // Kept by each thread, so that a warm remeshing allocates nothing.
  struct Scratch {
    FitParticles<D> particles;
    std::vector<double> c, b, a;
  };
  static Scratch& scratch() {
    thread_local Scratch scratch;
    return scratch;
  }
};

}  // namespace

template <class T, int D>
void fit_ghosts(const Body<T, D>& body, Population<T, D>& population, const FieldStore<T, D>& state,
                int block, const LevelSet<T, D>& level_set, const Boundaries<D>& boundaries,
                GhostTreatment treatment, std::int32_t* used) {
  BlockGhosts<T, D>& ghosts = population.ghosts[block];
  ghosts.slot.clear();
  ghosts.wall.clear();
  ghosts.active.clear();
  ghosts.contact.clear();
  ghosts.contact_height.clear();
  ghosts.contact_area.clear();
  ghosts.pressure.clear();
  ghosts.normal.clear();
  ghosts.foot.clear();
  ghosts.touches.clear();
  ghosts.bonds.clear();
  ghosts.begin.assign(1, 0);
  ghosts.neighbour.clear();
  ghosts.linear.clear();
  ghosts.constrained.clear();
  ghosts.constrained_sum.clear();
  ghosts.surface_sum.clear();
  ghosts.surface.clear();
  GhostFitter<T, D> fitter(body, population, state, block, level_set, boundaries, treatment, used);
  population.layout.for_each_slot(population.layout.blocks()[block],
                                  [&](std::int64_t p, const Cell<D>& cell) {
                                    const Kind kind = population.kind[p];
                                    if (kind == Kind::free_ghost || kind == Kind::wall_ghost)
                                      fitter.add(p, cell);
                                  });
  make_room(ghosts.record, ghosts.neighbour.size());
  ghosts.record.resize(ghosts.neighbour.size());
  ghosts.sums.grow(ghosts.slot.size() * 3 * kernels::record_width<D>, T(0));
}

template void fit_ghosts<double, 2>(const Body<double, 2>&, Population<double, 2>&,
                                    const FieldStore<double, 2>&, int, const LevelSet<double, 2>&,
                                    const Boundaries<2>&, GhostTreatment, std::int32_t*);
template void fit_ghosts<double, 3>(const Body<double, 3>&, Population<double, 3>&,
                                    const FieldStore<double, 3>&, int, const LevelSet<double, 3>&,
                                    const Boundaries<3>&, GhostTreatment, std::int32_t*);

}  // namespace pliant::remeshed
