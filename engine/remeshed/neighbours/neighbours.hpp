#pragma once

#include <vector>

#include "engine/remeshed/state/stage_results.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/material.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// Strain of (RP.24) up to which no slot outside the stencil can be within the support: 0.16, with
/// the compact kernel 0.12.
double stencil_strain(kernels::Kernel kernel);

/// Strain of one step, dt max abs(eps)_F, at which a step fails. Runge-Kutta stages with such
/// strains are far from the state at their start, and neighbour lists for them would be endless.
inline constexpr double largest_step_strain = 0.5;

/// Finds the neighbours of particles by position when slots outside the stencil may enter the
/// support, and again before the lists may become incomplete.
///
///     stencil reach   how near such slots are, when the strain since the last remeshing might have
///                     brought them close: usually the stencil is still enough
///     cells           sorts particles and ghosts into a cell list for each body
///     neighbours      the lists of each block, if the stencil is not enough
///
/// Sums over lists are bitwise equal to sums over the stencil, and do not depend on when the lists
/// were made: they run in the order of the stencil, and entries outside the support add zeros.
/// Lists are therefore not part of the state or of checkpoints.
template <class T, int D>
class NeighbourSearch {
 public:
  /// `in_every_step`: never use the stencil, and do not rely on any bound on the strain.
  NeighbourSearch(State<T, D>& state, kernels::Kernel kernel, bool in_every_step = false)
      : state_(state), kernel_(kernel), in_every_step_(in_every_step) {}

  /// Uses the stencil until stencil_strain: the slots are new, or lists are not known.
  void clear();

  /// Decides which bodies need a search before a step of `time_step` [s]. Returns whether any does.
  bool is_due(double time_step);

  /// Adds the strain of bodies in a step of `time_step` [s].
  void add_strain(const StageResults& results, double time_step);

  /// The phases of this search, over the blocks of all bodies; bodies without one cost almost
  /// nothing.
  std::vector<scheduler::Phase> phases();

 private:
  void measure(int block);
  void decide();
  void decide_after_measuring(BodyNeighbours<D>& neighbours) const;
  void prepare_search(Body<T, D>& body) const;

  State<T, D>& state_;
  kernels::Kernel kernel_;
  bool in_every_step_;
};

extern template class NeighbourSearch<double, 2>;
extern template class NeighbourSearch<double, 3>;
extern template class NeighbourSearch<float, 2>;
extern template class NeighbourSearch<float, 3>;

}  // namespace pliant::remeshed
