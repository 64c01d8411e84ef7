#include "engine/remeshed/ghost_fill.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "engine/remeshed/contact.hpp"
#include "kernels/ghost_state.hpp"

namespace pliant::remeshed {

namespace {

// (RP.39): the mean rigid motion of the neighbours, taken at the ghost.
template <class T, int D>
std::array<T, D> rigid_velocity(const Body<T, D>& body, const FieldStore<T, D>& state,
                                const BlockGhosts<T, D>& ghosts, std::size_t g) {
  using Vector3 = Eigen::Vector3d;
  const std::int64_t begin = ghosts.begin[g], end = ghosts.begin[g + 1];
  const Layout<D>& layout = body.population.layout;
  const auto position = [&](std::int64_t slot) {
    const Point<D> node = body.lattice.node(layout.cell(slot));
    Vector3 x = Vector3::Zero();
    for (int a = 0; a < D; ++a) x[a] = node[a] + state.get(Field::displacement, a)[slot];
    return x;
  };
  const auto velocity = [&](std::int64_t slot) {
    Vector3 u = Vector3::Zero();
    for (int a = 0; a < D; ++a) u[a] = state.get(Field::velocity, a)[slot];
    return u;
  };
  Vector3 centre = Vector3::Zero(), mean = Vector3::Zero();
  for (std::int64_t k = begin; k < end; ++k) {
    centre += position(ghosts.neighbour[k]) / (end - begin);
    mean += velocity(ghosts.neighbour[k]) / (end - begin);
  }
  Vector3 moment = Vector3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::int64_t k = begin; k < end; ++k) {
    const Vector3 r = position(ghosts.neighbour[k]) - centre;
    moment += r.cross(velocity(ghosts.neighbour[k]) - mean);
    inertia += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
  }
  // Neighbours in a line leave the rotation about it open: the least one is taken.
  const Vector3 omega = inertia.completeOrthogonalDecomposition().solve(moment);
  const Vector3 u = mean + omega.cross(position(ghosts.slot[g]) - centre);
  std::array<T, D> result;
  for (int a = 0; a < D; ++a) result[a] = static_cast<T>(u[a]);
  return result;
}

// The sums of all ghosts or, run by run, of those that are reached.
template <class T, int D>
void sum_ghosts(BlockGhosts<T, D>& ghosts, const T* records, WhichGhosts which,
                const kernels::Table<T, D>& table) {
  const std::size_t count = ghosts.slot.size();
  const auto is_wanted = [&](std::size_t g) {
    return which == WhichGhosts::all || ghosts.reached[g] != 0;
  };
  for (std::size_t end, begin = 0; begin < count; begin = end + 1) {
    for (end = begin; end < count && is_wanted(end);) ++end;
    if (end == begin) continue;
    table.sum_ghosts({static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end - begin),
                      ghosts.begin.data(), ghosts.record.data(), ghosts.linear.data(),
                      ghosts.constrained.data(), ghosts.surface.data(), records,
                      ghosts.sums.get() + 3 * kernels::record_width<D> * begin});
  }
}

}  // namespace

template <int D>
void BoundaryValues<D>::evaluate(const Boundaries<D>& boundaries, double t) {
  wall_velocity.clear();
  pressure.clear();
  for (const Wall<D>& wall : boundaries.walls) wall_velocity.push_back(wall.velocity(t));
  for (const SurfacePressure<D>& load : boundaries.pressures) pressure.push_back(load.value(t));
}

template <class T, int D>
void fill_ghosts(Body<T, D>& body, int block, int stage, int parity, WhichGhosts which,
                 const Boundaries<D>& boundaries, const BoundaryValues<D>& values,
                 GhostTreatment treatment, const kernels::Table<T, D>& table) {
  BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  sum_ghosts(ghosts, body.records.get(), which, table);
  release_contact(body, block, values);
  FieldStore<T, D>& state = body.stage[stage];
  const bool averaged = treatment == GhostTreatment::averaged;
  const kernels::Impedance<T> impedance(body.material);
  const BodyTouches<T, D>& touches = ghosts.touches;
  std::size_t touch = 0;
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    while (touch < touches.ghost.size() && touches.ghost[touch] < static_cast<std::int32_t>(g))
      ++touch;
    if (ghosts.active[g] == 0) continue;
    if (which == WhichGhosts::reached && ghosts.reached[g] == 0) continue;
    const kernels::GhostFits<T, D> fits = ghosts.fits(g);
    kernels::GhostState<T, D> ghost;
    if (const int w = ghosts.wall[g]; w >= 0) {
      std::array<T, D> velocity, normal;
      for (int a = 0; a < D; ++a) {
        velocity[a] = static_cast<T>(values.wall_velocity[w][a]);
        normal[a] = static_cast<T>(ghosts.normal[g][a]);
      }
      ghost = averaged ? kernels::averaged_wall_ghost<T, D>(fits.linear, velocity)
              : boundaries.walls[w].slips()
                  ? kernels::slip_wall_ghost<T, D>(fits, velocity, normal, impedance)
                  : kernels::wall_ghost<T, D>(fits, velocity, normal, impedance);
    } else if (touch < touches.ghost.size() &&
               touches.ghost[touch] == static_cast<std::int32_t>(g)) {
      const auto n = kernels::unit_normal<T, D>(fits.linear);
      kernels::SurfaceLoad<T, D> load{n, 0, touches.traction[touch]};
      for (int a = 0; a < D; ++a) load.normal += load.shear[a] * n[a];
      for (int a = 0; a < D; ++a) load.shear[a] -= load.normal * n[a];
      ghost = kernels::loaded_surface_ghost<T, D>(fits, load, impedance);
    } else {
      const int p = ghosts.pressure[g];
      const T pressure = p < 0 ? T(0) : static_cast<T>(values.pressure[p]);
      ghost = averaged ? kernels::averaged_surface_ghost<T, D>(fits.linear, pressure)
                       : kernels::free_surface_ghost<T, D>(fits, pressure, impedance);
      if (treatment == GhostTreatment::rigid) {
        ghost.velocity = rigid_velocity<T, D>(body, state, ghosts, g);
      }
    }
    const std::int64_t slot = ghosts.slot[g];
    for (int a = 0; a < D; ++a) state.get(Field::velocity, a)[slot] = ghost.velocity[a];
    for (std::size_t c = 0; c < ghost.stress.size(); ++c) {
      body.stress[parity][c][slot] = ghost.stress[c];
    }
  }
}

template <class T, int D>
void carry_ghosts(Body<T, D>& body, int block, int stage) {
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  for (int a = 0; a < D; ++a) {
    const T* start = body.stage[0].get(Field::velocity, a);
    const T* middle = body.stage[1].get(Field::velocity, a);
    T* velocity = body.stage[stage].get(Field::velocity, a);
    for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
      if (ghosts.reached[g] != 0) continue;
      const std::int64_t slot = ghosts.slot[g];
      velocity[slot] = stage == 2 ? middle[slot] : 2 * middle[slot] - start[slot];
    }
  }
}

template <class T, int D>
void fill_conserved(Body<T, D>& body, int block) {
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  FieldStore<T, D>& state = body.stage[0];
  const T volume = static_cast<T>(std::pow(body.lattice.spacing, D));
  T* mass = state.get(Field::mass);
  T* v = state.get(Field::volume);
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    if (ghosts.active[g] == 0) continue;
    const std::int64_t slot = ghosts.slot[g];
    const auto fit = [&](auto&& value) {
      T sum = 0;
      for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
        sum += ghosts.linear[k] * value(ghosts.neighbour[k]);
      }
      return sum;
    };
    mass[slot] = volume * fit([&](std::int64_t q) { return mass[q] / v[q]; });
    v[slot] = volume;
    for (const Field f : {Field::material, Field::memory}) {
      for (Buffer<T>& component : state[f]) {
        component[slot] = fit([&](std::int64_t q) { return component[q]; });
      }
    }
    for (int a = 0; a < D; ++a) {
      T* carried = state.get(Field::carried, a);
      const T* drift = state.get(Field::displacement, a);
      carried[slot] = fit([&](std::int64_t q) { return carried[q] + drift[q]; }) - drift[slot];
    }
  }
}

template struct BoundaryValues<2>;
template void fill_ghosts<double, 2>(Body<double, 2>&, int, int, int, WhichGhosts,
                                     const Boundaries<2>&, const BoundaryValues<2>&, GhostTreatment,
                                     const kernels::Table<double, 2>&);
template void carry_ghosts<double, 2>(Body<double, 2>&, int, int);
template void fill_conserved<double, 2>(Body<double, 2>&, int);
template struct BoundaryValues<3>;
template void fill_ghosts<double, 3>(Body<double, 3>&, int, int, int, WhichGhosts,
                                     const Boundaries<3>&, const BoundaryValues<3>&, GhostTreatment,
                                     const kernels::Table<double, 3>&);
template void carry_ghosts<double, 3>(Body<double, 3>&, int, int);
template void fill_conserved<double, 3>(Body<double, 3>&, int);

}  // namespace pliant::remeshed
