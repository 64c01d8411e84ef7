#include "engine/remeshed/ghosts/rim_ghosts.hpp"

#include <algorithm>
#include <cmath>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "engine/storage/push_tightly.hpp"

namespace pliant::remeshed {

namespace {

/// The no-slip wall behind which a place lies, or -1; h is the spacing. On the wall itself rounding
/// would decide.
template <int D>
int holding_wall(const Boundaries<D>& boundaries, const Point<D>& x, double h) {
  constexpr double least_depth = 0.01;  // [h]
  const auto [w, distance] = boundaries.nearest_wall(x);
  const bool holds =
      w >= 0 && distance < -least_depth * h && std::isinf(boundaries.walls[w].friction());
  return holds ? w : -1;
}

/// The part of a rim ghost's velocity that the wall determines. Material that rolls down onto the
/// wall must not stick to it before it touches: less where the free surface leans over the wall.
/// `foot` is where they meet, n the normal of the wall, h the spacing.
template <class T, int D>
double share_of_wall(const LevelSet<T, D>& level_set, Point<D> foot, const Point<D>& n, double h) {
  constexpr double low = 1.5, high = 2.5;              // [h] heights above the wall
  constexpr double upright = 0.1, overhanging = 0.35;  // slopes
  const auto phi_at = [&](double height) {
    Point<D> x = foot;
    for (int a = 0; a < D; ++a) x[a] += height * h * n[a];
    return level_set.phi_at(x);
  };
  const double slope = (phi_at(low) - phi_at(high)) / ((high - low) * h);
  return std::clamp((overhanging - slope) / (overhanging - upright), 0., 1.);
}

/// b of (RP.46) for the particles of a ghost of the free surface: their distances from the wall
/// take the place of those from the surface.
template <class T, int D>
bool fit_to_wall(const FittedGhost<T, D>& ghost, const Position<D>& n,
                 kernels::FitTerms<T, D>& terms) {
  FitParticles<D> particles = ghost.particles;
  for (FitParticle<D>& i : particles) i.surface_distance = n.dot(i.position);
  const FitSite<D> site{ghost.site.ghost, n, n.dot(ghost.site.ghost)};
  return fit_constrained(particles, site, 0, terms);
}

/// b of a particle; n is the normal of the wall through the foot point.
template <class T, int D>
T coefficient(const kernels::FitTerms<T, D>& terms, const T (&r)[D], const std::array<T, D>& n) {
  T distance = 0;
  for (int a = 0; a < D; ++a) distance += n[a] * r[a];
  return kernels::fit_coefficients(terms, r, distance).constrained;
}

}  // namespace

template <class T, int D>
void list_at_rim(const FittedGhost<T, D>& ghost, const Lattice<D>& lattice,
                 const LevelSet<T, D>& level_set, const Boundaries<D>& boundaries,
                 BlockGhosts<T, D>& ghosts) {
  const double h = lattice.spacing;
  Point<D> x = ghost.foot;
  for (int a = 0; a < D; ++a) x[a] += h * ghost.site.ghost[a];
  const int w = holding_wall<D>(boundaries, x, h);
  if (w < 0) return;
  const Point<D> normal = boundaries.walls[w].normal(ghost.foot);
  const double share = share_of_wall<T, D>(level_set, ghost.foot, normal, h);
  kernels::FitTerms<T, D> terms = ghost.terms;
  const Position<D> inwards(normal.data());
  if (share == 0 || !fit_to_wall<T, D>(ghost, inwards, terms)) return;
  std::array<T, D> n;
  for (int a = 0; a < D; ++a) n[a] = static_cast<T>(normal[a]);
  double sum = 0;
  Position<D> mean = Position<D>::Zero();
  for (const FitParticle<D>& i : ghost.particles) {
    T r[D];
    for (int a = 0; a < D; ++a) r[a] = static_cast<T>(i.position[a]);
    const T b = coefficient<T, D>(terms, r, n);
    sum += b;
    mean += b * i.position;
  }
  const Position<D> beyond = h * (ghost.site.ghost - mean) / (1 - sum);
  Point<D> point = ghost.foot;
  for (int a = 0; a < D; ++a) point[a] += beyond[a];
  push_tightly(ghosts.rim_ghost, ghost.number);
  push_tightly(ghosts.rim_wall, static_cast<std::int8_t>(w));
  push_tightly(ghosts.rim_share, static_cast<T>(share));
  push_tightly(ghosts.rim_point, point);
  push_tightly(ghosts.rim_normal, n);
  push_tightly(ghosts.rim_terms, terms);
}

template <class T, int D>
void fill_rim_ghosts(const Body<T, D>& body, BlockGhosts<T, D>& ghosts, std::size_t count,
                     const Surroundings<D>& around, FieldStore<T, D>& state) {
  for (std::size_t k = 0; k < ghosts.rim_ghost.size(); ++k) {
    const std::size_t g = ghosts.rim_ghost[k];
    if (g >= count || ghosts.active[g] == 0) continue;
    const Point<D> wall = around.values.wall_motion[ghosts.rim_wall[k]].of(ghosts.rim_point[k]);
    std::array<T, D> change = {};  // sum b (u - u_w)
    for (std::int64_t i = ghosts.begin[g]; i < ghosts.begin[g + 1]; ++i) {
      const FittedParticle<T, D> particle(ghosts, g, i);
      const T b = coefficient<T, D>(ghosts.rim_terms[k], particle.r, ghosts.rim_normal[k]);
      const kernels::RecordSum<T, D> record{
          body.records.get() + static_cast<std::int64_t>(kernels::record_of(ghosts.pairs[i])) *
                                   kernels::record_width<D>};
      for (int a = 0; a < D; ++a) {
        change[a] += b * (record.velocity(a) - static_cast<T>(wall[a]));
      }
    }
    for (int a = 0; a < D; ++a) {
      T& u = state.get(Field::velocity, a)[ghosts.slot[g]];
      u += ghosts.rim_share[k] * (static_cast<T>(wall[a]) + change[a] - u);
    }
    ghosts.correction[g] = {};
  }
}

template void list_at_rim<double, 2>(const FittedGhost<double, 2>&, const Lattice<2>&,
                                     const LevelSet<double, 2>&, const Boundaries<2>&,
                                     BlockGhosts<double, 2>&);
template void fill_rim_ghosts<double, 2>(const Body<double, 2>&, BlockGhosts<double, 2>&,
                                         std::size_t, const Surroundings<2>&,
                                         FieldStore<double, 2>&);
template void list_at_rim<float, 2>(const FittedGhost<float, 2>&, const Lattice<2>&,
                                    const LevelSet<float, 2>&, const Boundaries<2>&,
                                    BlockGhosts<float, 2>&);
template void fill_rim_ghosts<float, 2>(const Body<float, 2>&, BlockGhosts<float, 2>&, std::size_t,
                                        const Surroundings<2>&, FieldStore<float, 2>&);
template void list_at_rim<double, 3>(const FittedGhost<double, 3>&, const Lattice<3>&,
                                     const LevelSet<double, 3>&, const Boundaries<3>&,
                                     BlockGhosts<double, 3>&);
template void fill_rim_ghosts<double, 3>(const Body<double, 3>&, BlockGhosts<double, 3>&,
                                         std::size_t, const Surroundings<3>&,
                                         FieldStore<double, 3>&);
template void list_at_rim<float, 3>(const FittedGhost<float, 3>&, const Lattice<3>&,
                                    const LevelSet<float, 3>&, const Boundaries<3>&,
                                    BlockGhosts<float, 3>&);
template void fill_rim_ghosts<float, 3>(const Body<float, 3>&, BlockGhosts<float, 3>&, std::size_t,
                                        const Surroundings<3>&, FieldStore<float, 3>&);

}  // namespace pliant::remeshed
