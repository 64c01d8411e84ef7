#include "engine/finite_elements/step.hpp"

#include <algorithm>

#include "engine/method/phase_rows.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/point_room.hpp"

// A step of total Lagrangian explicit dynamics (Miller et al. 2007). All work is in the elements of
// the undeformed body.
//
//     drift       displacement at the time of the kick: half a step on for the leapfrog (PB.10)
//     loads       forces of pressures (PB.11), tractions and gravity (PB.15) on each node
//     dilatation  change of volume of each element, distributed to its corners (FE.3)
//     pressure    of each node, from what its elements have collected (FE.4), (FE.8)
//     forces      F of each element, the stress, and the forces on its corners (FE.1)-(FE.5)
//     motion      the force on each node; velocity and displacement (PB.10); the velocity that
//                 walls prescribe, and the work of walls and loads
//     contact ...     as in the point-based method (TL.12), (TL.15), (TL.16)
//
// Without averaged pressure there are no phases `dilatation` and `pressure`. A node sums what
// several blocks have collected for it in the order of the blocks.
namespace pliant::finite_elements {

using scheduler::Phase;
using enum Group;

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings, kernels::Isa isa)
    : state_(state),
      settings_(settings),
      kernels_(kernels::FiniteElementsTable<T, D>::of(isa)),
      nodes_(state, settings, kernels::PointBasedTable<T, D>::of(isa)) {}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  nodes_.prepare_blocks();
  results_.assign(state_.blocks.size(), {-1});
  const bool averages =
      std::any_of(state_.elements.begin(), state_.elements.end(),
                  [](const Elements<T, D>& elements) { return elements.averages(); });
  std::vector<Phase> phases;
  PhaseRows rows(phases);
  if (point_based::is_leapfrog(settings_)) {
    rows.each("drift", own(of(velocity) + of(displacement)), own(of(displacement)),
              [this](int block) { nodes_.drift(block); });
  }
  if (nodes_.loads_act()) {
    rows.each("loads", near(of(displacement)) + own(of(constants)), own(of(loads)),
              [this](int block) { nodes_.load(block); });
  }
  if (averages) {
    rows.each("dilatation", near(of(displacement)) + own(of(constants)),
              own(of(own_sums) + of(halo_sums)),
              [this](int block) { kernels_.collect_dilatation(elements_of(block)); });
    rows.each("pressure", near(of(halo_sums)) + own(of(own_sums) + of(constants)),
              own(of(own_sums) + of(pressures)), [this](int block) { evaluate_pressures(block); });
  }
  rows.each("forces", near(of(displacement) + of(pressures)) + own(of(constants)),
            own(of(own_sums) + of(halo_sums) + of(results)),
            [this](int block) { evaluate_forces(block); });
  rows.each("motion",
            near(of(halo_sums)) +
                own(of(own_sums) + of(constants) + of(loads) + of(velocity) + of(displacement)),
            own(of(own_sums) + of(velocity) + of(displacement) + of(results)),
            [this](int block) { nodes_.move(block); });
  nodes_.add_contact(rows, {of(displacement) + of(velocity), of(constants), of(contact_lists),
                            of(contact_places), of(contact_normals), of(touches)});
  if (nodes_.bodies_touch()) {
    rows.each("work", own(of(velocity) + of(constants) + of(loads) + of(own_sums)),
              own(of(own_sums) + of(results)), [this](int block) { nodes_.end_motion(block); });
  }
  return phases;
}

template <class T, int D>
void Step<T, D>::prepare(const undeformed::Advance& advance) {
  examine_ = advance.examine;
  nodes_.prepare(advance);
}

template <class T, int D>
undeformed::StepResult Step<T, D>::fold() {
  undeformed::StepResult result;
  for (std::size_t b = 0; b < results_.size() && result.non_finite < 0; ++b) {
    result.non_finite = results_[b].non_finite;
    result.failed_block = static_cast<int>(b);
  }
  const undeformed::StepResult of_nodes = nodes_.fold();
  result.overlap = of_nodes.overlap;
  result.secant = of_nodes.secant;
  return result;
}

template <class T, int D>
kernels::ElementBlock<T, D> Step<T, D>::elements_of(int block) {
  const BlockOwner& owner = state_.blocks[block];
  point_based::Body<T, D>& body = state_.bodies[owner.body];
  Elements<T, D>& elements = state_.elements[owner.body];
  const point_based::NodeBlock& range = body.blocks[owner.block];
  const ElementRange& own = elements.blocks[owner.block];
  kernels::ElementBlock<T, D> work = {};
  work.first = range.first;
  work.count = range.count;
  work.halo_count = range.halo_count;
  work.halo = body.halo.data() + range.first_halo;
  work.elements = own.count;
  work.corner = elements.corner.get() + own.first * (D + 1);
  work.shape = elements.shape.get() + own.first * kernels::element_values<D>;
  if (elements.is_prestressed()) {
    work.initial_stress =
        elements.initial_stress.get() + own.first * kernels::symmetric_components<D>;
  }
  for (int a = 0; a < D; ++a) work.displacement[a] = body.displacement[a].get();
  work.material = elements.material;
  work.volumetric_modulus = elements.volumetric_modulus;
  work.examine = examine_;
  work.point = point_based::room_for_points<T>(body.most_points);
  work.force = body.force.get() + kernels::point_stride * range.first_point();
  return work;
}

template <class T, int D>
void Step<T, D>::evaluate_pressures(int block) {
  const BlockOwner& owner = state_.blocks[block];
  point_based::Body<T, D>& body = state_.bodies[owner.body];
  Elements<T, D>& elements = state_.elements[owner.body];
  const point_based::NodeBlock& range = body.blocks[owner.block];
  kernels::NodalPressures<T> work = {};
  work.first = range.first;
  work.count = range.count;
  work.collected = body.collected[owner.block].data();
  work.collected_count = static_cast<int>(body.collected[owner.block].size());
  work.force = body.force.get() + kernels::point_stride * range.first_point();
  work.modulus = elements.volumetric_modulus;
  work.volume = body.volume.get();
  work.bulk = nodes_.bulk_relaxation(block);
  work.pressure = elements.pressure.get();
  kernels_.evaluate_nodal_pressures(work);
}

template <class T, int D>
void Step<T, D>::evaluate_forces(int block) {
  kernels::ElementBlock<T, D> work = elements_of(block);
  const Elements<T, D>& elements = state_.elements[state_.blocks[block].body];
  if (elements.averages()) work.pressure = elements.pressure.get();
  results_[block] = kernels_.evaluate_forces(work);
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::finite_elements
