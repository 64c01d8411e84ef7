#include "engine/point_based/step.hpp"

#include "engine/method/phase_rows.hpp"
#include "engine/point_based/degenerate_nodes.hpp"

// A step of the point-based method. Everything happens on the bonds of the undeformed body.
//
//     drift     displacement at the time of the kick: half a step on for the leapfrog (PB.10)
//     pressure  what pressures exert on the undeformed surface around each node (PB.11)
//     forces    F at each node from the nodes that it has bonds with, the stress, and its force
//               along the bonds (PB.4)-(PB.9), collected for own nodes and for those of other
//               blocks
//     motion    the force on each node; velocity and displacement (PB.10); the velocity that walls
//               set
//
// A block adds up the forces on its nodes in the order of the blocks that collected them, so that
// the sums do not depend on the number of threads.
namespace pliant::point_based {

using scheduler::Phase;
using enum Group;

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::PointBasedTable<T, D>& kernels)
    : state_(state), settings_(settings), kernels_(kernels) {}

template <class T, int D>
bool Step<T, D>::is_leapfrog() const {
  return settings_.point_based.integrator == Integrator::leapfrog;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  results_.assign(state_.blocks.size(), {-1});
  const auto run = [this](auto function) {
    return [this, function](int block) { (this->*function)(block); };
  };
  std::vector<Phase> phases;
  PhaseRows rows(phases);
  if (is_leapfrog()) {
    rows.each("drift", own(of(velocity) + of(displacement)), own(of(displacement)),
              run(&Step::drift));
  }
  if (!state_.boundaries.pressures.empty()) {
    rows.each("pressure", own(of(constants)), own(of(loads)), run(&Step::load_pressures));
  }
  rows.each("forces", near(of(displacement)) + own(of(constants) + of(loads) + of(strain)),
            own(of(points) + of(own_forces) + of(halo_forces) + of(strain) + of(results)),
            run(&Step::evaluate_forces));
  rows.each("motion",
            near(of(halo_forces)) +
                own(of(own_forces) + of(constants) + of(loads) + of(velocity) + of(displacement)),
            own(of(own_forces) + of(velocity) + of(displacement)), run(&Step::move));
  return phases;
}

template <class T, int D>
void Step<T, D>::prepare(const Advance& advance) {
  advance_ = advance;
  const double middle = advance.time + advance.length / 2;
  const double kick = is_leapfrog() ? middle : advance.time;
  pressure_.clear();
  for (const auto& pressure : state_.boundaries.pressures) {
    pressure_.push_back(pressure.value(kick));
  }
  wall_velocity_.clear();
  for (const Wall<D>& wall : state_.boundaries.walls) {
    wall_velocity_.push_back(wall.velocity(middle));
  }
}

template <class T, int D>
StepResult Step<T, D>::fold() const {
  StepResult result;
  for (std::size_t b = 0; b < results_.size() && result.non_finite < 0; ++b) {
    result = {results_[b].non_finite, static_cast<int>(b)};
  }
  return result;
}

template <class T, int D>
void Step<T, D>::drift(int block) {
  const auto [body, local] = owner(block);
  kernels::PointDrift<T, D> work = {};
  work.first = body.blocks[local].first;
  work.count = body.blocks[local].count;
  work.drift = static_cast<T>(advance_.length / 2);
  for (int a = 0; a < D; ++a) {
    work.velocity[a] = body.velocity[a].get();
    work.displacement[a] = body.displacement[a].get();
  }
  kernels_.drift(work);
}

template <class T, int D>
void Step<T, D>::load_pressures(int block) {
  const auto [body, local] = owner(block);
  for (const PressedNode<D>& node : body.pressed[local]) {
    for (int a = 0; a < D; ++a) body.pressure_load[a][node.slot] = T(0);
  }
  for (const PressedNode<D>& node : body.pressed[local]) {
    for (int a = 0; a < D; ++a) {
      body.pressure_load[a][node.slot] += static_cast<T>(pressure_[node.pressure] * node.area[a]);
    }
  }
}

template <class T, int D>
void Step<T, D>::evaluate_forces(int block) {
  const auto [body, local] = owner(block);
  const NodeBlock& range = body.blocks[local];
  kernels::PointForces<T, D> work = {};
  work.first = range.first;
  work.count = range.count;
  work.bonds = body.bonds;
  work.neighbour = body.neighbour.get() + range.first * body.bonds;
  work.bond = body.bond.get() + range.first * body.bonds * (D + 1);
  work.halo_count = range.halo_count;
  work.halo = body.halo.data() + range.first_halo;
  work.volume = body.volume.get();
  work.stiffness = body.stiffness.get();
  for (int a = 0; a < D; ++a) {
    work.displacement[a] = body.displacement[a].get();
    if (!body.pressed[local].empty()) work.load[a] = body.pressure_load[a].get();
  }
  for (int c = 0; c < Body<T, D>::symmetric; ++c) {
    work.moment[c] = body.moment[c].get();
    work.strain[c] = body.strain[c].get();
  }
  work.viscosity = static_cast<T>(settings_.point_based.stiffness_damping / advance_.length);
  work.examine = advance_.examine;
  work.material = body.material;
  work.point = body.point.get() + kernels::point_stride * range.first_point();
  work.force = body.force.get() + kernels::point_stride * range.first_point();
  for (int c = 0; c < D * D; ++c) work.kept[c] = body.kept_gradient[c].get();
  results_[block] = kernels_.evaluate_forces(work);
  if (!body.degenerate[local].empty()) add_degenerate_forces(body, local);
}

template <class T, int D>
void Step<T, D>::move(int block) {
  const auto [body, local] = owner(block);
  const NodeBlock& range = body.blocks[local];
  kernels::PointMotion<T, D> work = {};
  work.first = range.first;
  work.count = range.count;
  work.collected = body.collected[local].data();
  work.collected_count = static_cast<int>(body.collected[local].size());
  work.force = body.force.get() + kernels::point_stride * range.first_point();
  const double half = settings_.point_based.damping * advance_.length / 2;
  work.kept = static_cast<T>((1 - half) / (1 + half));
  work.gained = static_cast<T>(advance_.length / (1 + half));
  work.drift = static_cast<T>(is_leapfrog() ? advance_.length / 2 : advance_.length);
  work.inverse_mass = body.inverse_mass.get();
  for (int a = 0; a < D; ++a) {
    if (body.is_loaded()) work.external[a] = body.traction[a].get();
    work.velocity[a] = body.velocity[a].get();
    work.displacement[a] = body.displacement[a].get();
  }
  kernels_.advance(work);
  apply_walls(body, local);
}

// Undoes what a constrained node has moved against its walls, in their order: where two walls meet,
// the last one counts.
template <class T, int D>
void Step<T, D>::apply_walls(Body<T, D>& body, int local) {
  const double moved = is_leapfrog() ? advance_.length / 2 : advance_.length;
  for (const ConstrainedNode<D>& held : body.held[local]) {
    Point<D> excess;
    double along = 0, slips = 0;
    for (int a = 0; a < D; ++a) {
      excess[a] = body.velocity[a][held.slot] - wall_velocity_[held.wall][a];
      along += excess[a] * held.normal[a];
      slips += held.normal[a] * held.normal[a];
    }
    for (int a = 0; a < D; ++a) {
      const double undone = slips > 0 ? along * held.normal[a] : excess[a];
      body.velocity[a][held.slot] -= static_cast<T>(undone);
      body.displacement[a][held.slot] -= static_cast<T>(moved * undone);
    }
  }
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::point_based
