#include "engine/remeshed/observe/integrals.hpp"

#include <cmath>

#include "engine/remeshed/observe/motion_integrals.hpp"
#include "engine/remeshed/observe/point_state.hpp"

namespace pliant::remeshed {

namespace {

/// The integrals over a block.
template <class T, int D>
BodyIntegrals integrate_block(const LatticeView<T, D>& view, const CoveredCells<T, D>& cells,
                              const Block<D>& block, const Vector& about) {
  const double h = view.body.lattice.spacing, cell_volume = std::pow(h, D);
  BodyIntegrals sum;
  MotionIntegrals motion;
  const auto energy = [&view](std::int64_t p) {
    return energy_density<T, D>(view.body, view.fields, p);
  };
  cells.for_each(block, [&](std::int64_t p, const Cell<D>& cell, const Moments<D>& moments) {
    Point<D> r = view.body.lattice.node(cell), slope = {};
    const Point<D> passed = passed_periods<T, D>(view.body.lattice, view.fields, p, cell);
    for (int a = 0; a < D; ++a) r[a] += passed[a] - about[a];
    if (moments.first != Point<D>{}) {
      cells.for_each_pair(cell, [&](int a, std::int64_t up, std::int64_t down) {
        slope[a] = (energy(up) - energy(down)) / 2;
      });
    }
    sum.volume += cell_volume * moments.zeroth;
    sum.strain_energy += cell_volume * integral<D>(energy(p), slope, moments.zeroth, moments.first);
    motion.add<D>(h, r, NodeMotion<D>(view.fields, cells, p, cell), moments);
  });
  sum.mass = motion.mass / view.body.mass_scaling;
  for (int a = 0; a < 3; ++a) {
    sum.first_moment[a] = motion.first_moment[a] / view.body.mass_scaling;
  }
  sum.momentum = motion.momentum;
  sum.angular_momentum = motion.angular_momentum;
  sum.kinetic_energy = motion.kinetic_energy;
  return sum;
}

}  // namespace

template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about) {
  const CoveredCells<T, D> cells(view, boundaries);
  BodyIntegrals sum;
  for (const Block<D>& block : view.population.layout.blocks()) {
    add(sum, integrate_block(view, cells, block, about));
  }
  return sum;
}

template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about, scheduler::Workers& workers) {
  const CoveredCells<T, D> cells(view, boundaries);
  const auto& blocks = view.population.layout.blocks();
  return workers.sum<BodyIntegrals>(static_cast<int>(blocks.size()), [&](int b) {
    return integrate_block(view, cells, blocks[b], about);
  });
}

template <class T, int D>
BodyIntegrals sum_particles(const Body<T, D>& body, const Vector& about) {
  BodyIntegrals sum;
  const FieldStore<T, D>& f = body.stage[0];
  const Layout<D>& layout = body.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      const Point<D> x = body.position(p, cell);
      const Point<D> passed = passed_periods<T, D>(body.lattice, f, p, cell);
      Vector r = {}, u = {};
      for (int a = 0; a < D; ++a) {
        r[a] = x[a] + passed[a] - about[a];
        u[a] = f.get(Field::velocity, a)[p];
      }
      const double volume = f.get(Field::volume)[p];
      sum.volume += volume;
      const double mass = f.get(Field::mass)[p] / body.mass_scaling;
      sum.mass += mass;
      sum.strain_energy += energy_density<T, D>(body, f, p) * volume;
      add_motion(sum, mass, r, u, body.mass_scaling);
    });
  }
  return sum;
}

template BodyIntegrals integrate<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&,
                                            const Vector&);
template BodyIntegrals integrate<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&,
                                            const Vector&, scheduler::Workers&);
template BodyIntegrals sum_particles<double, 2>(const Body<double, 2>&, const Vector&);
template BodyIntegrals integrate<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&,
                                            const Vector&);
template BodyIntegrals integrate<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&,
                                            const Vector&, scheduler::Workers&);
template BodyIntegrals sum_particles<double, 3>(const Body<double, 3>&, const Vector&);
template BodyIntegrals integrate<float, 2>(const LatticeView<float, 2>&, const Boundaries<2>&,
                                           const Vector&);
template BodyIntegrals integrate<float, 2>(const LatticeView<float, 2>&, const Boundaries<2>&,
                                           const Vector&, scheduler::Workers&);
template BodyIntegrals sum_particles<float, 2>(const Body<float, 2>&, const Vector&);
template BodyIntegrals integrate<float, 3>(const LatticeView<float, 3>&, const Boundaries<3>&,
                                           const Vector&);
template BodyIntegrals integrate<float, 3>(const LatticeView<float, 3>&, const Boundaries<3>&,
                                           const Vector&, scheduler::Workers&);
template BodyIntegrals sum_particles<float, 3>(const Body<float, 3>&, const Vector&);

}  // namespace pliant::remeshed
