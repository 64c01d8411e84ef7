#pragma once

#include "kernels/finite_elements/element_forces.hpp"

/// Pressures at the nodes, (FE.4), in two passes: elements distribute their change of volume to
/// their corners, and nodes sum what blocks have collected for them.
namespace pliant::kernels {

template <ElasticLaw law, class P, int D>
inline void collect_dilatation_of(const ElementBlock<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  collect_points<P, D>(block, block.pressure);
  for (int element = 0; element < block.elements; element += lanes<P>) {
    const ElementLanes<P, D> at(block, element);
    P f[D * D], share[D];
    element_gradient<P, D>(block, at, f);
    for (P& component : share) component = P(T(0));
    // Subtracted, so the sum is negative.
    share[0] = load<P>(at.volume()) * dilatation<law, P, D>(f) * P(T(1. / (D + 1)));
    for (int a = 0; a <= D; ++a) PointLanes<P, D>::subtract(share, at.corners(a), block.force);
  }
}

/// Adds V_e theta_e/(D + 1) of the elements of a block to the first component of their corners.
template <class P, int D>
void collect_dilatation(const ElementBlock<Scalar<P>, D>& block) {
  if (block.material.law == ElasticLaw::st_venant_kirchhoff) {
    collect_dilatation_of<ElasticLaw::st_venant_kirchhoff, P, D>(block);
  } else {
    collect_dilatation_of<ElasticLaw::neo_hookean, P, D>(block);
  }
}

/// The sum of the p_i at a node, advanced by (RP.22).
template <class P>
Scalar<P> relaxed_pressure(const BulkRelaxation<Scalar<P>>& bulk, std::int64_t slot,
                           Scalar<P> end) {
  using T = Scalar<P>;
  T sum(0);
  for (int i = 0; i < bulk.terms; ++i) {
    const Relaxation<T>& term = bulk.relaxation[i];
    T& pressure = bulk.next_pressure[i][slot];
    pressure = term.decay * bulk.pressure[i][slot] + term.start * bulk.volume_change[slot] +
               term.end * end;
    sum += pressure;
  }
  bulk.next_volume_change[slot] = end;
  return sum;
}

/// See NodalPressures. This and `relaxed_pressure` depend on `P` so that each instruction set has
/// its own function.
template <class P>
void evaluate_nodal_pressures(const NodalPressures<Scalar<P>>& block) {
  using T = Scalar<P>;
  for (int c = 0; c < block.collected_count; ++c) {
    const CollectedForces<T>& from = block.collected[c];
    for (int i = 0; i < from.count; ++i) {
      block.force[point_stride * (from.slot[i] - block.first)] += from.force[point_stride * i];
    }
  }
  for (int i = 0; i < block.count; ++i) {
    const std::int64_t slot = block.first + i;
    const T volume = block.volume[slot];
    const T theta = volume > 0 ? -block.force[point_stride * i] / volume : T(0);
    block.pressure[slot] = block.modulus * theta;
    if (block.bulk.terms > 0) block.pressure[slot] -= relaxed_pressure<P>(block.bulk, slot, theta);
  }
}

}  // namespace pliant::kernels
