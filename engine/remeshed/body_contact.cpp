#include "engine/remeshed/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/remeshed/resources.hpp"
#include "engine/remeshed/surface_fits.hpp"
#include "kernels/interface_traction.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;
using scheduler::Reach;

constexpr double fit_radius = 2.6;  // [h], as that of ghosts
// How far apart surfaces may still stand [h]: more touches too early.
constexpr double touching_gap = 0.05;
// Time in which a gap or an overlap is to vanish [h/c]: shorter rings, longer lets bodies sink in.
constexpr double closing_time = 10;

kernels::InterfaceKind converted(ContactCase::Kind kind) {
  switch (kind) {
    case ContactCase::Kind::frictionless:
      return kernels::InterfaceKind::frictionless;
    case ContactCase::Kind::sticking:
      return kernels::InterfaceKind::sticking;
    case ContactCase::Kind::bonded:
      break;
  }
  return kernels::InterfaceKind::bonded;
}

/// Partition of unity over the layers of ghosts: 1 at `distance` = centre, 0 one spacing away.
double hat(double distance, double centre) {
  return std::max(0., 1 - std::abs(distance - centre));
}

/// Share of the surface of a ghost at `distance` from it, both over h. Parallel surfaces grow with
/// their distance by a polynomial of degree D - 1: those at h, 2 h [and 3 h] tell the one at 0.
template <int D>
double surface_share(double distance) {
  if constexpr (D == 2) return 2 * hat(distance, 1) - hat(distance, 2);
  return 3 * (hat(distance, 1) - hat(distance, 2)) + hat(distance, 3);
}

}  // namespace

/// The other body about a foot point.
template <class T, int D>
class BodyContact<T, D>::Partner {
 public:
  /// False where there is too little of it.
  bool find(const Surface& surface, const Body<T, D>& body, const Point<D>& x) {
    particles_.clear();
    around_.clear();
    Point<D> at;
    for (int a = 0; a < D; ++a) {
      at[a] = (x[a] - body.lattice.origin[a]) / body.lattice.spacing - 0.5;
      const std::int32_t n = body.lattice.period[a];
      if (n != 0) at[a] -= n * std::floor(at[a] / n);
    }
    surface.cells.any_near(at, [&](const Site<D>& site, const Cell<D>& shift) {
      Position<D> r;
      for (int a = 0; a < D; ++a) r[a] = site.position[a] + shift[a] - at[a];
      const double fraction = r.squaredNorm() / (fit_radius * fit_radius);
      if (fraction >= 1) return false;
      const FitParticle<D> sample{site.slot, (1 - fraction) * (1 - fraction),
                                  surface.level_set[site.slot], r};
      around_.push_back(sample);
      if (surface.record[site.slot] >= 0) particles_.push_back(sample);
      return false;
    });
    FitSite<D> site = {Position<D>::Zero(), Position<D>::Zero(), 0};
    unused_.clear();
    of_level_set_.clear();
    coefficient_.clear();
    return fit_in_all_directions<D>(around_, site, unused_, of_level_set_) &&
           fit_in_all_directions<D>(particles_, site, unused_, coefficient_);
  }

  double gap() const {  ///< [h]
    double sum = 0;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      sum += of_level_set_[i] * around_[i].surface_distance;
    }
    return sum;
  }

  void add_to(BodyTouches<T, D>& touches, const Surface& surface) const {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      touches.record.push_back(surface.record[particles_[i].slot]);
      touches.coefficient.push_back(static_cast<T>(coefficient_[i]));
    }
    touches.begin.push_back(static_cast<std::int64_t>(touches.record.size()));
  }

 private:
  FitParticles<D> particles_, around_;
  std::vector<double> coefficient_, of_level_set_, unused_;
};

template <class T, int D>
BodyContact<T, D>::BodyContact(State<T, D>& state, const Case& settings,
                               const kernels::Table<T, D>& kernels)
    : state_(state),
      contacts_(settings.contacts),
      kernels_(kernels),
      contacts_of_(settings.bodies.size()),
      surfaces_(settings.bodies.size()) {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    for (const int body : contacts_[c].bodies) contacts_of_[body].push_back(static_cast<int>(c));
  }
}

template <class T, int D>
void BodyContact<T, D>::add_search(std::vector<Phase>& phases) {
  phases.push_back({"touches: samples",
                    -1,
                    {{resource::drift(0)}},
                    {{resource::surface_samples}},
                    Phase::Extent::per_block,
                    {},
                    [this](int block) { find_samples(block); }});
  phases.push_back({"touches: samples",
                    -1,
                    {{resource::surface_samples, Reach::all}},
                    {{resource::surface_cells, Reach::all}},
                    Phase::Extent::once,
                    {},
                    [this](int) { sort_samples(); }});
  phases.push_back({"touches",
                    -1,
                    {{resource::surface_cells, Reach::all},
                     {resource::drift(0), Reach::neighbours}},
                    {{resource::touches}},
                    Phase::Extent::per_block,
                    {},
                    [this](int block) { find_touches(block); }});
}

template <class T, int D>
void BodyContact<T, D>::add_tractions(std::vector<Phase>& phases, int stage) {
  phases.push_back({"tractions",
                    stage,
                    {{resource::records, Reach::all}, {resource::touches}},
                    {{resource::tractions}},
                    Phase::Extent::per_block,
                    {},
                    [this, stage](int block) { find_tractions(block, stage); }});
}

template <class T, int D>
void BodyContact<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  samples_.resize(state_.blocks.size());
  impulse_.assign(state_.blocks.size() * contacts_.size(), {});
}

template <class T, int D>
std::vector<Point<D>> BodyContact<T, D>::fold() const {
  std::vector<Point<D>> impulse(contacts_.size(), Point<D>{});
  for (std::size_t i = 0; i < impulse_.size(); ++i) {
    for (int a = 0; a < D; ++a) impulse[i % contacts_.size()][a] += impulse_[i][a];
  }
  return impulse;
}

template <class T, int D>
void BodyContact<T, D>::find_samples(int block) {
  std::vector<Sample>& samples = samples_[block];
  samples.clear();
  if (contacts_of_[state_.blocks[block].body].empty()) return;
  const Body<T, D>& body = body_of(block);
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  const T* phi = body.stage[0].get(Field::level_set);
  const auto add = [&](std::int64_t slot, const Cell<D>& cell, std::int32_t record) {
    Sample sample{{{}, cell, 0}, record, phi[slot] / h};
    for (int a = 0; a < D; ++a) {
      double& x = sample.site.position[a];
      x = cell[a] + body.stage[0].get(Field::displacement, a)[slot] / h;
      const std::int32_t n = body.lattice.period[a];
      if (n != 0) x -= n * std::floor(x / n);
    }
    samples.push_back(sample);
  };
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[state_.blocks[block].block];
  const Block<D>& range = layout.blocks()[state_.blocks[block].block];
  for (const kernels::SurfacePack& pack : ghosts.packs) {
    const kernels::Segment<D>& segment = layout.segments()[range.first_segment + pack.segment];
    std::int32_t record = pack.record;
    for (int l = 0; l < Layout<D>::pack; ++l) {
      if ((pack.lanes >> l & 1) == 0) continue;
      Cell<D> cell = segment.cell;
      cell[0] += static_cast<std::int32_t>(pack.first - segment.first) + l;
      add(pack.first + l, cell, record++);
    }
  }
  for (const std::int32_t slot : ghosts.slot) add(slot, layout.cell(slot), -1);
}

template <class T, int D>
void BodyContact<T, D>::sort_samples() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (Surface& surface : surfaces_) {
    surface.lower.fill(infinity);
    surface.upper.fill(-infinity);
    surface.is_near_another = false;
    surface.record.clear();
    surface.level_set.clear();
  }
  for (std::size_t b = 0; b < samples_.size(); ++b) {
    Surface& surface = surfaces_[state_.blocks[b].body];
    for (Sample& sample : samples_[b]) {
      sample.site.slot = static_cast<std::int32_t>(surface.record.size());
      surface.record.push_back(sample.record);
      surface.level_set.push_back(sample.level_set);
      for (int a = 0; a < D; ++a) {
        surface.lower[a] = std::min(surface.lower[a], sample.site.position[a]);
        surface.upper[a] = std::max(surface.upper[a], sample.site.position[a]);
      }
    }
  }
  std::vector<Point<D>> lower, upper;  // in cells, for the cells' cubes
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    Surface& surface = surfaces_[s];
    const Lattice<D>& lattice = state_.bodies[s].lattice;
    lower.push_back(surface.lower);
    upper.push_back(surface.upper);
    for (int a = 0; a < D; ++a) {
      const bool ends = lattice.period[a] == 0;
      surface.lower[a] = ends ? lattice.origin[a] + (surface.lower[a] + 0.5) * lattice.spacing
                              : -infinity;
      surface.upper[a] = ends ? lattice.origin[a] + (surface.upper[a] + 0.5) * lattice.spacing
                              : infinity;
    }
  }
  for (const ContactCase& contact : contacts_) {
    Surface& first = surfaces_[contact.bodies[0]];
    Surface& second = surfaces_[contact.bodies[1]];
    bool near = true;
    for (int a = 0; a < D; ++a) {
      near = near && first.lower[a] < second.upper[a] && second.lower[a] < first.upper[a];
    }
    first.is_near_another = first.is_near_another || near;
    second.is_near_another = second.is_near_another || near;
  }
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    Surface& surface = surfaces_[s];
    if (!surface.is_near_another) continue;
    const std::size_t count = surface.record.size();
    surface.cells.cover(lower[s], upper[s], state_.bodies[s].lattice.period, fit_radius, count);
    surface.cells.sort(count, [&](auto&& f) {
      for (std::size_t b = 0; b < samples_.size(); ++b) {
        if (state_.blocks[b].body != static_cast<int>(s)) continue;
        for (const Sample& sample : samples_[b]) f(sample.site);
      }
    });
  }
}

template <class T, int D>
void BodyContact<T, D>::find_touches(int block) {
  BlockGhosts<T, D>& ghosts = ghosts_of(block);
  BodyTouches<T, D>& touches = ghosts.touches;
  touches.ghost.clear();
  touches.contact.clear();
  touches.gap.clear();
  touches.area.clear();
  touches.begin.assign(1, 0);
  touches.record.clear();
  touches.coefficient.clear();
  touches.traction.clear();
  const int own = state_.blocks[block].body;
  if (!surfaces_[own].is_near_another) return;
  const Body<T, D>& body = state_.bodies[own];
  const double h = body.lattice.spacing;
  thread_local Partner partner;
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    if (ghosts.wall[g] >= 0 || ghosts.surface_sum[g] < T(0.5)) continue;
    Point<D> x = ghosts.foot[g];
    for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
      for (int a = 0; a < D; ++a) {
        x[a] += ghosts.surface[k] *
                body.stage[0].get(Field::displacement, a)[ghosts.neighbour[k]];
      }
    }
    double nearest = touching_gap;
    for (const int c : contacts_of_[own]) {
      const std::array<int, 2>& pair = contacts_[c].bodies;
      const int other = pair[0] == own ? pair[1] : pair[0];
      const Surface& surface = surfaces_[other];
      bool near = surface.is_near_another;
      for (int a = 0; a < D; ++a) near = near && x[a] > surface.lower[a] && x[a] < surface.upper[a];
      if (!near || !partner.find(surface, state_.bodies[other], x)) continue;
      const double gap = partner.gap();
      if (contacts_[c].kind != ContactCase::Kind::bonded && gap >= nearest) continue;
      if (!touches.ghost.empty() && touches.ghost.back() == static_cast<std::int32_t>(g)) {
        // Nearer to this body than to the one before.
        touches.ghost.pop_back();
        touches.contact.pop_back();
        touches.gap.pop_back();
        touches.area.pop_back();
        touches.begin.pop_back();
        touches.record.resize(touches.begin.back());
        touches.coefficient.resize(touches.begin.back());
      }
      nearest = gap;
      touches.ghost.push_back(static_cast<std::int32_t>(g));
      touches.contact.push_back(c);
      touches.gap.push_back(static_cast<T>(gap * h));
      const double phi = body.stage[0].get(Field::level_set)[ghosts.slot[g]] / h;
      touches.area.push_back(static_cast<T>(std::pow(h, D - 1) * surface_share<D>(phi)));
      partner.add_to(touches, surface);
    }
  }
  touches.traction.resize(touches.ghost.size());
}

template <class T, int D>
void BodyContact<T, D>::find_tractions(int block, int stage) {
  constexpr int width = kernels::record_width<D>;
  BlockGhosts<T, D>& ghosts = ghosts_of(block);
  BodyTouches<T, D>& touches = ghosts.touches;
  const int own = state_.blocks[block].body;
  const Body<T, D>& body = state_.bodies[own];
  for (std::size_t k = 0; k < touches.ghost.size(); ++k) {
    const std::int32_t g = touches.ghost[k];
    const ContactCase& contact = contacts_[touches.contact[k]];
    const bool is_first = contact.bodies[0] == own;
    const Body<T, D>& other = state_.bodies[contact.bodies[is_first ? 1 : 0]];
    kernels_.sum_ghosts({g, 1, ghosts.begin.data(), ghosts.record.data(), ghosts.linear.data(),
                         ghosts.constrained.data(), ghosts.surface.data(), body.records.get(),
                         ghosts.sums.get() + 3 * width * g});
    std::array<T, width> sum = {};
    for (std::int64_t i = touches.begin[k]; i < touches.begin[k + 1]; ++i) {
      const T* record = other.records.get() + static_cast<std::int64_t>(touches.record[i]) * width;
      for (int f = 0; f < width; ++f) sum[f] += touches.coefficient[i] * record[f];
    }
    const kernels::GhostFits<T, D> fits = ghosts.fits(g);
    const kernels::InterfaceSide<T, D> here{fits.surface, kernels::Impedance<T>(body.material)};
    const kernels::InterfaceSide<T, D> there{{sum.data()}, kernels::Impedance<T>(other.material)};
    const T speed = std::min(kernels::wave_speed_at_rest(body.material),
                             kernels::wave_speed_at_rest(other.material));
    const T closing = touches.gap[k] * speed / static_cast<T>(closing_time * body.lattice.spacing);
    const kernels::SurfaceLoad<T, D> load = kernels::interface_traction<T, D>(
        here, there, kernels::unit_normal<T, D>(fits.linear), closing, converted(contact.kind));
    const T share = static_cast<T>(stage_weight[stage] * time_step_ / 2) * touches.area[k];
    Point<D>& impulse = impulse_[block * contacts_.size() + touches.contact[k]];
    for (int a = 0; a < D; ++a) {
      touches.traction[k][a] = load.normal * load.n[a] + load.shear[a];
      // On the second body; the mean of what both sides find.
      impulse[a] += (is_first ? -share : share) * touches.traction[k][a];
    }
  }
}

template class BodyContact<double, 2>;
template class BodyContact<double, 3>;

}  // namespace pliant::remeshed
