#include "engine/total_lagrangian/boundary_forces.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::total_lagrangian {

namespace {

/// Finds facet `number` where a load on this area finds it.
template <class T, int D>
void follow(const Body<T, D>& body, int number, BoundaryCase::LoadedArea area,
            PresentFacet<D>& facet) {
  facet.number = number;
  facet.area_of_load = area;
  for (int v = 0; v < D; ++v) {
    const Vertex<D>& vertex = body.facets[number].vertex[v];
    facet.corner[v] =
        area == BoundaryCase::LoadedArea::undeformed ? vertex.start : body.position(vertex);
  }
  facet.area = area_vector<D>(facet.corner);
}

/// The force of the patches on the i-th loaded particle of a block.
template <class T, int D>
Point<D> load_on(const Body<T, D>& body, const NodalLoads& loads, std::size_t i) {
  Point<D> sum = {};
  for (std::int32_t k = loads.begin[i]; k < loads.begin[i + 1]; ++k) {
    const Point<D>& force = body.patch_force[loads.patch[k]];
    for (int a = 0; a < D; ++a) sum[a] += loads.weight[k] * force[a];
  }
  return sum;
}

/// The vector in the plane of a facet with `components` along its sides from the first corner.
template <int D>
Point<D> in_plane(const std::array<Point<D>, D>& x, const std::array<double, D - 1>& components) {
  constexpr int sides = D - 1;
  Eigen::Matrix<double, D, sides> side;
  for (int i = 0; i < sides; ++i) {
    for (int a = 0; a < D; ++a) side(a, i) = x[i + 1][a] - x[0][a];
  }
  const Eigen::Map<const Eigen::Matrix<double, sides, 1>> given(components.data());
  const Eigen::Matrix<double, sides, sides> products = side.transpose() * side;
  Point<D> vector;
  Eigen::Map<Eigen::Matrix<double, D, 1>>(vector.data()) = side * (products.inverse() * given);
  return vector;
}

template <class T, int D>
double along(const std::array<Buffer<T>, D>& velocity, std::int64_t p, const Point<D>& force) {
  double power = 0;
  for (int a = 0; a < D; ++a) power += force[a] * velocity[a][p];
  return power;
}

}  // namespace

template <class T, int D>
BoundaryForces<T, D>::BoundaryForces(State<T, D>& state, const Case& settings)
    : state_(state), gravity_(settings), work_(state) {}

template <class T, int D>
void BoundaryForces<T, D>::prepare_blocks() {
  work_.clear_blocks();
  for (const Body<T, D>& body : state_.bodies) work_.add_blocks(body);
}

template <class T, int D>
void BoundaryForces<T, D>::prepare(double time, double kick, double length) {
  time_ = time;
  at_start_.evaluate(state_.boundaries, time);
  work_.prepare({time, length, kick, length});
}

template <class T, int D>
void BoundaryForces<T, D>::sum_patch_loads(int block) {
  const Owned owned = owner(block);
  Body<T, D>& body = owned.body;
  // The patches of a facet follow one another.
  PresentFacet<D> facet;
  for (int i = body.first_patch[owned.local]; i < body.first_patch[owned.local + 1]; ++i) {
    const SurfacePatch<D>& patch = body.patches[i];
    const auto area = state_.boundaries.pressures[patch.pressure].area();
    if (patch.facet != facet.number || area != facet.area_of_load) {
      follow(body, patch.facet, area, facet);
    }
    body.patch_force[i] = force_on(patch, facet);
  }
}

// The force of a pressure rotates with the surface.
template <class T, int D>
Point<D> BoundaryForces<T, D>::force_on(const SurfacePatch<D>& patch,
                                        const PresentFacet<D>& facet) const {
  const SurfacePressure<D>& load = state_.boundaries.pressures[patch.pressure];
  const auto& [number, area_of_load, x, area] = facet;
  const Point<D> middle = patch.corner == whole_facet
                              ? undeformed::middle_of<D>(x)
                              : undeformed::middle_of_share<D>(x, patch.corner);
  Point<D> force;
  if (load.is_traction()) {
    const Point<D> traction = at_start_.traction_at(patch.pressure, middle);
    const double loaded = patch.share * norm<D>(area);
    for (int a = 0; a < D; ++a) force[a] = loaded * traction[a];
    return force;
  }
  const double pressure = at_start_.pressure_at(patch.pressure, middle);
  for (int a = 0; a < D; ++a) force[a] = -pressure * patch.share * area[a];
  if (patch.aside == std::array<double, D - 1>{}) return force;
  const double size = norm<D>(area);
  const Point<D> aside = in_plane<D>(x, patch.aside);
  for (int a = 0; a < D; ++a) force[a] -= pressure * size * aside[a];
  return force;
}

template <class T, int D>
void BoundaryForces<T, D>::distribute(int block) {
  if (gravity_.acts()) set_gravity(block);
  const Owned owned = owner(block);
  Body<T, D>& body = owned.body;
  const NodalLoads& nodal_loads = body.nodal_loads[owned.local];
  for (std::size_t i = 0; i < nodal_loads.slot.size(); ++i) {
    const Point<D> sum = load_on(body, nodal_loads, i);
    for (int a = 0; a < D; ++a) {
      T& traction = body.traction[a][nodal_loads.slot[i]];
      traction = static_cast<T>(gravity_.acts() ? traction + sum[a] : sum[a]);
    }
  }
}

template <class T, int D>
void BoundaryForces<T, D>::set_gravity(int block) {
  const Owned owned = owner(block);
  Body<T, D>& body = owned.body;
  const typename Gravity<D>::Now gravity(gravity_, time_);
  const Block<D>& range = body.layout.blocks()[owned.local];
  body.layout.for_each_slot(range, [&](std::int64_t p, const Cell<D>& cell) {
    if (!body.is_particle(p)) return;
    Point<D> x = body.lattice.node(cell);
    for (int a = 0; a < D; ++a) x[a] += body.displacement[a][p];
    const Point<D> g = gravity(x);
    for (int a = 0; a < D; ++a) body.traction[a][p] = static_cast<T>(body.mass[p] * g[a]);
  });
}

// Power of loads and gravity at the present velocities.
template <class T, int D>
EnergyBudget BoundaryForces<T, D>::power_of(int block) {
  EnergyBudget power;
  if (!act_on_particles()) return power;
  const Owned owned = owner(block);
  const Body<T, D>& body = owned.body;
  const NodalLoads& nodal_loads = body.nodal_loads[owned.local];
  const auto traction_of = [&](std::int64_t p) {
    Point<D> force;
    for (int a = 0; a < D; ++a) force[a] = body.traction[a][p];
    return force;
  };
  for (std::size_t i = 0; i < nodal_loads.slot.size(); ++i) {
    const std::int32_t p = nodal_loads.slot[i];
    const Point<D> force = gravity_.acts() ? load_on(body, nodal_loads, i) : traction_of(p);
    power.load_work += along<T, D>(body.velocity, p, force);
  }
  if (!gravity_.acts()) return power;
  double of_all = 0;
  const Block<D>& range = body.layout.blocks()[owned.local];
  body.layout.for_each_slot(range, [&](std::int64_t p, const Cell<D>&) {
    if (body.is_particle(p)) of_all += along<T, D>(body.velocity, p, traction_of(p));
  });
  power.body_force_work = of_all - power.load_work;
  return power;
}

template <class T, int D>
void BoundaryForces<T, D>::begin_motion(int block) {
  const Owned owned = owner(block);
  work_.begin_motion(block, owned.body, owned.local, power_of(block));
}

template <class T, int D>
void BoundaryForces<T, D>::hold(int block) {
  const Owned owned = owner(block);
  work_.hold(block, owned.body, owned.local, owned.body.end_displacement);
}

template <class T, int D>
void BoundaryForces<T, D>::end_motion_after_contact(int block) {
  const auto [body, local] = owner(block);
  const Block<D>& range = body.layout.blocks()[local];
  work_.after_contact(block, body, range.first_slot, range.slot_count);
  end_motion(block);
}

template <class T, int D>
void BoundaryForces<T, D>::end_motion(int block) {
  work_.end_motion(block, power_of(block));
}

template class BoundaryForces<double, 2>;
template class BoundaryForces<double, 3>;
template class BoundaryForces<float, 2>;
template class BoundaryForces<float, 3>;

}  // namespace pliant::total_lagrangian
