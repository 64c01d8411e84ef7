#pragma once

#include <array>

#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// Stress and energy of a node whose bonds span only a plane or a line.
template <int D>
struct DegenerateState {
  std::array<double, D* D> bond_stress = {};  ///< V P Q^T, row-major, (PB.13)
  double energy = 0;                          ///< [J]
};

/// The state by (PB.13). It is exact under rotation; the law of all D directions would not be here.
template <class T, int D>
DegenerateState<D> degenerate_state(const Body<T, D>& body, const NodeBlock& block,
                                    const DegenerateNode<D>& node);

/// Adds the forces of the degenerate nodes of a block to its collected forces.
template <class T, int D>
void add_degenerate_forces(Body<T, D>& body, int block);

}  // namespace pliant::point_based
