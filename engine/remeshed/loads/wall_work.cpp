#include "engine/remeshed/loads/wall_work.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/remeshed/ghosts/present_foot.hpp"
#include "engine/remeshed/ghosts/share_in_front_of_walls.hpp"
#include "engine/remeshed/ghosts/wall_layer.hpp"
#include "engine/remeshed/ghosts/wall_site.hpp"
#include "kernels/remeshed/ghosts/wall_friction.hpp"

namespace pliant::remeshed {

namespace {

// Share of a slot in the part of a wall that the body covers; phi is in spacings, (RP.65). Walls
// that hold the body have ghosts as far as the body reaches, (RP.97). The last one also represents
// the rest.
double covered_share(double phi, bool slips) {
  if (slips) return std::clamp(0.5 - phi, 0., 1.);
  return phi > -1 ? 0.5 - phi : 1;
}

// The part of the wall under the body that a ghost represents, (RP.65).
template <class T, int D>
double area_on_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                    bool slips) {
  const double h = body.lattice.spacing;
  const std::int64_t slot = ghosts.slot[g];
  const double covered = covered_share(body.stage[0].get(Field::level_set)[slot] / h, slips);
  if (covered == 0) return 0;
  const double depth = depth_behind_wall<T, D>(body, ghosts, g);
  return std::pow(h, D - 1) * weight_in_layer<D>(ghosts.normal[g], depth / h) * covered;
}

// F of (RP.65) around a slot, from the separation of the slots beside it since the remeshing.
template <class T, int D>
WallStretch<D> stretch_around(const Body<T, D>& body, std::int64_t slot, int stage) {
  const Layout<D>& layout = body.population.layout;
  const Cell<D> cell = layout.cell(slot);
  WallStretch<D> f = WallStretch<D>::Identity();
  for (int j = 0; j < D; ++j) {
    Cell<D> up = cell, down = cell;
    ++up[j];
    --down[j];
    const std::int64_t q = layout.slot(body.lattice.wrapped(up));
    const std::int64_t r = layout.slot(body.lattice.wrapped(down));
    if (q < 0 || r < 0) continue;
    for (int i = 0; i < D; ++i) {
      const T* drift = body.stage[drift_buffer_of(stage)].get(Field::drift, i);
      f(i, j) += (drift[q] - drift[r]) / (2 * body.lattice.spacing);
    }
  }
  return f;
}

// The share of the ghost's part that is in front of other walls, at the start of a step. Sliding
// material moves its part of the wall along and stretches it.
template <class T, int D>
double share_before_others(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                           const Boundaries<D>& boundaries) {
  const int wall = ghosts.wall[g];
  const std::int64_t slot = ghosts.slot[g];
  const Point<D> foot = present_foot(body, ghosts, g, 0);
  const double h = body.lattice.spacing;
  if (!boundaries.walls[wall].slips()) {
    return share_in_front_of_walls<D>(boundaries, wall, foot, ghosts.normal[g], h);
  }
  return share_in_front_of_walls<D>(boundaries, wall, foot, ghosts.normal[g], h,
                                    [&] { return stretch_around(body, slot, 0); });
}

}  // namespace

template <class T, int D>
double growth_on_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                      int stage) {
  const WallStretch<D> f = stretch_around(body, ghosts.slot[g], stage);
  const Eigen::Map<const Eigen::Matrix<double, D, 1>> normal(ghosts.normal[g].data());
  return f.determinant() * (f.transpose().inverse() * normal).norm();
}

// The tests that need no distance to other walls come first, since they exclude most ghosts.
template <class T, int D>
void find_wall_shares(const Body<T, D>& body, int block, const Boundaries<D>& boundaries,
                      const std::vector<char>& watched, std::vector<WallShare>& shares) {
  shares.clear();
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  for (std::size_t g = 0; g < ghosts.reached_count; ++g) {
    const int wall = ghosts.wall[g];
    if (wall < 0 || watched[wall] == 0) continue;
    double area = area_on_wall(body, ghosts, g, boundaries.walls[wall].slips());
    if (area == 0) continue;
    area *= share_before_others(body, ghosts, g, boundaries);
    if (area > 0) shares.push_back({static_cast<std::int32_t>(g), area});
  }
}

template <class T, int D>
void WallWork<T, D>::add(std::size_t g, const kernels::GhostFits<T, D>& fits,
                         const kernels::WallSite<T, D>& site) {
  if (shares_.empty() || std::cmp_not_equal(shares_.front().ghost, g)) return;
  double area = shares_.front().area;
  shares_ = shares_.subspan(1);
  const int wall = ghosts_.wall[g];
  if (around_.boundaries.walls[wall].slips()) area *= growth_on_wall(body_, ghosts_, g, stage_);
  const auto push = kernels::wall_force_density<T, D>(fits, site, impedance_);
  Point<D> given;
  for (int a = 0; a < D; ++a) given[a] = duration_ * area * push[a];
  if (!pushes_.empty()) {
    pushes_[wall].add(present_foot(body_, ghosts_, g, stage_), given, duration_ * area);
  }
  for (int a = 0; a < D; ++a) {
    if (lone_walls_[a] == wall) continue;
    impulse_[wall][a] += given[a];
    work_ += given[a] * around_.values.wall_motion[wall].velocity[a];
  }
}

template double growth_on_wall<double, 2>(const Body<double, 2>&, const BlockGhosts<double, 2>&,
                                          std::size_t, int);
template void find_wall_shares<double, 2>(const Body<double, 2>&, int, const Boundaries<2>&,
                                          const std::vector<char>&, std::vector<WallShare>&);
template class WallWork<double, 2>;
template double growth_on_wall<double, 3>(const Body<double, 3>&, const BlockGhosts<double, 3>&,
                                          std::size_t, int);
template void find_wall_shares<double, 3>(const Body<double, 3>&, int, const Boundaries<3>&,
                                          const std::vector<char>&, std::vector<WallShare>&);
template class WallWork<double, 3>;
template double growth_on_wall<float, 2>(const Body<float, 2>&, const BlockGhosts<float, 2>&,
                                         std::size_t, int);
template void find_wall_shares<float, 2>(const Body<float, 2>&, int, const Boundaries<2>&,
                                         const std::vector<char>&, std::vector<WallShare>&);
template class WallWork<float, 2>;
template double growth_on_wall<float, 3>(const Body<float, 3>&, const BlockGhosts<float, 3>&,
                                         std::size_t, int);
template void find_wall_shares<float, 3>(const Body<float, 3>&, int, const Boundaries<3>&,
                                         const std::vector<char>&, std::vector<WallShare>&);
template class WallWork<float, 3>;

}  // namespace pliant::remeshed
