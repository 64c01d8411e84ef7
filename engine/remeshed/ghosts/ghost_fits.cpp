#include "engine/remeshed/ghosts/ghost_fits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/contact/contact_edges.hpp"
#include "engine/remeshed/contact/wall_contact.hpp"
#include "engine/remeshed/ghosts/ghost_fitter.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/ghosts/share_in_front_of_walls.hpp"
#include "engine/storage/push_tightly.hpp"

namespace pliant::remeshed {

namespace {

// Whether a particle or its image has the slot in its stencil. The offset to a row that does not
// exist may lead anywhere; the particle found is then one of another cell.
template <class T, int D>
bool is_reached(const Population<T, D>& population, const kernels::Segment<D>& segment,
                std::int64_t slot, const Cell<D>& cell, int reach) {
  const int depth = D == 3 ? reach : 0;
  for (int dz = -depth; dz <= depth; ++dz) {
    for (int dy = -reach; dy <= reach; ++dy) {
      const std::int64_t row = slot + segment.neighbour_row[kernels::row_index<D>(dy, dz)];
      for (int dx = -reach; dx <= reach; ++dx) {
        if (dx * dx + dy * dy + dz * dz >= (reach + 1) * (reach + 1)) continue;
        const Kind kind = population.kind[row + dx];
        if (kind != Kind::interior && kind != Kind::image) continue;
        Cell<D> other = cell;
        other[0] += dx;
        other[1] += dy;
        if constexpr (D == 3) other[2] += dz;
        if (population.layout.slot(other) == row + dx) return true;
      }
    }
  }
  return false;
}

/// Finds the ghosts of a block and the places around which they are fitted.
template <class T, int D>
class GhostFinder {
 public:
  GhostFinder(const GhostSearch<T, D>& search, int block, std::int32_t* used)
      : body_(search.body),
        population_(search.population),
        level_set_(search.level_set),
        ghosts_(population_.ghosts[block]),
        boundaries_(search.boundaries),
        treatment_(search.treatment),
        stencil_reach_(search.stencil_reach),
        edges_(body_, population_, level_set_, boundaries_),
        fitter_(body_, population_, ghosts_, level_set_, boundaries_, search.corners,
                search.kernels, used) {}

  void add_all(const Block<D>& block) {
    drifting_.clear();
    const Layout<D>& layout = population_.layout;
    for (int s = block.first_segment; s < block.first_segment + block.segment_count; ++s) {
      const kernels::Segment<D>& segment = layout.segments()[s];
      Cell<D> cell = segment.cell;
      for (int i = 0; i < segment.count; ++i, ++cell[0]) add(segment, segment.first + i, cell);
    }
    ghosts_.end_reached(ghosts_.slot.size());
    edge_ = no_edge;
    for (const auto& [slot, cell] : drifting_) add_drifting(slot, cell);
    fitter_.finish();
  }

 private:
  void add(const kernels::Segment<D>& segment, std::int64_t slot, const Cell<D>& cell) {
    edge_ = no_edge;
    const Kind kind = population_.kind[slot];
    if (kind != Kind::free_ghost && kind != Kind::wall_ghost) return;
    const double h = body_.lattice.spacing;
    const Point<D> x = body_.lattice.node(cell);
    if (kind == Kind::wall_ghost) {
      const auto [wall, distance] = boundaries_.nearest_wall(x);
      if (may_drift(wall, distance) &&
          !is_reached<T, D>(population_, segment, slot, cell, stencil_reach_)) {
        drifting_.push_back({slot, cell});
      } else {
        add_wall(slot, cell, wall, distance);
      }
      return;
    }
    const auto [wall, distance] = boundaries_.nearest_contact(x);
    // When the wall passes a row of nodes, that row is in the gap between the surface and the wall.
    const double height =
        distance < contact_onset_height * h ? level_set_.surface_distance(slot) + distance : h;
    if (distance < 0) edge_ = edges_.beyond(slot, x, wall);
    // The body comes no nearer than this before the next remeshing.
    if (height < h || edge_ != no_edge) {
      add_free(slot, cell);
      add_contact(slot, cell, wall, height);
    } else if (is_reached<T, D>(population_, segment, slot, cell, stencil_reach_)) {
      add_free(slot, cell);
    } else {
      drifting_.push_back({slot, cell});
    }
  }

  // Whether a ghost behind an attached wall may drift if no particle reaches it: not less than 2 h
  // deep, since the force of the wall needs it, (RP.65), nor behind walls with slip, where its
  // velocity depends on the stress, (RP.47).
  bool may_drift(int wall, double distance) const {
    return treatment_ != GhostTreatment::averaged &&
           std::isinf(boundaries_.walls[wall].friction()) && distance <= -2 * body_.lattice.spacing;
  }

  void add_drifting(std::int64_t slot, const Cell<D>& cell) {
    if (population_.kind[slot] != Kind::wall_ghost) return add_free(slot, cell);
    const auto [wall, distance] = boundaries_.nearest_wall(body_.lattice.node(cell));
    add_wall(slot, cell, wall, distance);
  }

  void add_contact(std::int64_t slot, const Cell<D>& cell, int wall, double height) {
    const double h = body_.lattice.spacing;
    const double distance = boundaries_.walls[wall].distance(body_.lattice.node(cell));
    ghosts_.contact.push_back(static_cast<std::int32_t>(ghosts_.slot.size()));
    add_wall(slot, cell, wall, distance);
    ghosts_.active.back() = was_in_contact(cell);
    const Point<D>& normal = ghosts_.normal.back();
    for (int a = 0; a < D; ++a) height += normal[a] * boundaries_.walls[wall].pose().offset[a];
    ghosts_.contact_height.push_back(height);
    const double layer = std::max(0., 1 - std::abs(distance / h + 1));
    const auto share = [&] {
      const Point<D>& foot = ghosts_.foot.back();
      const double spread = boundaries_.walls[wall].spread(body_.lattice.node(cell), -distance);
      const double apart = h * std::pow(spread, 1. / (D - 1));  // distance of feet on a curved wall
      return spread * WallCover<T, D>(body_.lattice, level_set_).share(foot, normal) *
             share_in_front_of_walls<D>(boundaries_, wall, foot, normal, apart);
    };
    ghosts_.contact_area.push_back(layer > 0 ? std::pow(h, D - 1) * layer * share() : 0);
  }

  // Whether the slot was in contact before this remeshing, (RP.52).
  bool was_in_contact(const Cell<D>& cell) const {
    const Population<T, D>& before = body_.population;
    if (before.layout.blocks().empty()) return false;
    const std::int64_t slot = before.layout.slot(cell);
    return slot >= 0 && before.kind[slot] == Kind::wall_ghost;
  }

  void add_wall(std::int64_t slot, const Cell<D>& cell, int wall, double distance) {
    const Point<D> x = body_.lattice.node(cell), normal = boundaries_.walls[wall].normal(x);
    Point<D> foot = x;
    for (int a = 0; a < D; ++a) foot[a] -= distance * normal[a];
    FitSite<D> site = site_of(x, foot, distance);
    for (int a = 0; a < D; ++a) site.normal[a] = normal[a];
    list(slot, wall, normal, foot);
    ghosts_.edge.back() = edge_;
    fit(site, cell, foot, &boundaries_.walls[wall]);
  }

  void add_free(std::int64_t slot, const Cell<D>& cell) {
    const Point<D> x = body_.lattice.node(cell);
    Point<D> foot = x, offset = {};
    level_set_.closest_point(slot, offset);
    for (int a = 0; a < D; ++a) foot[a] += offset[a];
    // Where the surface continues behind a wall, fits are around the wall.
    const auto [wall, depth] = boundaries_.nearest_wall(foot);
    if (depth < 0) {
      const Point<D> out = boundaries_.walls[wall].normal(foot);
      for (int a = 0; a < D; ++a) foot[a] -= depth * out[a];
    }
    FitSite<D> site = site_of(x, foot, level_set_.surface_distance(slot));
    const Point<D> outward = level_set_.outward(cell, difference<D>(foot, x));
    for (int a = 0; a < D; ++a) site.normal[a] = outward[a];
    list(slot, -1, {}, foot);
    if (edge_ == no_edge) ghosts_.edge.back() = edges_.beside(x, foot, ghosts_.normal.back());
    fit(site, cell, foot, nullptr);
  }

  FitSite<D> site_of(const Point<D>& x, const Point<D>& foot, double distance) const {
    const double h = body_.lattice.spacing;
    FitSite<D> site;
    for (int a = 0; a < D; ++a) site.ghost[a] = (x[a] - foot[a]) / h;
    site.surface_distance = distance / h;
    return site;
  }

  void list(std::int64_t slot, int wall, const Point<D>& normal, const Point<D>& foot) {
    push_tightly(ghosts_.slot, static_cast<std::int32_t>(slot));
    push_tightly(ghosts_.wall, static_cast<std::int8_t>(wall));
    push_tightly(ghosts_.active, std::uint8_t{1});
    push_tightly(ghosts_.pressure, no_load);
    push_tightly(ghosts_.edge, no_edge);
    push_tightly(ghosts_.normal, normal);
    push_tightly(ghosts_.foot, foot);
    push_tightly(ghosts_.correction, std::array<T, D>{});
    push_tightly(ghosts_.lasting, std::array<T, D>{});
  }

  void fit(const FitSite<D>& site, const Cell<D>& cell, const Point<D>& foot, const Wall<D>* wall) {
    if (treatment_ == GhostTreatment::averaged) {
      fitter_.average(cell);
    } else {
      fitter_.fit(site, foot, wall, ghosts_.edge.back() != no_edge);
    }
  }

  using Ghosts = std::vector<std::pair<std::int64_t, Cell<D>>>;

  // Reused by each thread, so that later remeshings do not allocate.
  static Ghosts& scratch() {
    thread_local Ghosts scratch;
    return scratch;
  }

  const Body<T, D>& body_;
  Population<T, D>& population_;
  const LevelSet<T, D>& level_set_;
  BlockGhosts<T, D>& ghosts_;
  const Boundaries<D>& boundaries_;
  GhostTreatment treatment_;
  int stencil_reach_;
  ContactEdges<T, D> edges_;
  std::int32_t edge_ = no_edge;  // edge of contact of the present slot, behind a contact wall
  GhostFitter<T, D> fitter_;
  Ghosts& drifting_ = scratch();
};

}  // namespace

template <class T, int D>
void fit_ghosts(const GhostSearch<T, D>& search, int block, std::int32_t* used) {
  BlockGhosts<T, D>& ghosts = search.population.ghosts[block];
  ghosts.clear();
  GhostFinder<T, D>(search, block, used).add_all(search.population.layout.blocks()[block]);
  // Kernels load whole registers of these.
  for (int i = 1; i < Layout<D>::pack; ++i) {
    if (!ghosts.pairs.empty()) push_tightly(ghosts.pairs, ghosts.pairs.back());
    if (!ghosts.wall_distance.empty()) push_tightly(ghosts.wall_distance, T(0));
  }
}

template void fit_ghosts<double, 2>(const GhostSearch<double, 2>&, int, std::int32_t*);
template void fit_ghosts<double, 3>(const GhostSearch<double, 3>&, int, std::int32_t*);
template void fit_ghosts<float, 2>(const GhostSearch<float, 2>&, int, std::int32_t*);
template void fit_ghosts<float, 3>(const GhostSearch<float, 3>&, int, std::int32_t*);

}  // namespace pliant::remeshed
