#pragma once

#include <vector>

#include "engine/remeshed/state/stage_results.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/material.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// Strain of (RP.24) up to which no slot from outside the stencil can be within the support: 0.16,
/// with the compact kernel 0.12.
double stencil_strain(kernels::Kernel kernel);

/// Strain of one step, dt max abs(eps)_F, at which a step fails: Runge-Kutta stages that strain so
/// much are far from the state that they started from, and lists of neighbours for them endless.
inline constexpr double largest_step_strain = 0.5;

/// Finds the neighbours of particles by position once slots from outside the stencil come into the
/// support, and again before what was found may miss some.
///
///     stencil reach   how near such slots are, once the strain since the last remeshing might have
///                     brought them: mostly the stencil goes on serving
///     cells           where particles and ghosts are, sorted into a cell list for each body
///     neighbours      the lists of each block, where the stencil does not serve
///
/// Sums over lists have the bits of sums over the stencil, and do not depend on when the lists were
/// made: they run in the order of the stencil, and what lies outside the support adds zeros. What
/// a search finds is therefore no part of the state, and no checkpoint holds it.
template <class T, int D>
class NeighbourSearch {
 public:
  /// `in_every_step`: the stencil never serves, and no bound on the strain is relied upon.
  NeighbourSearch(State<T, D>& state, kernels::Kernel kernel, bool in_every_step = false)
      : state_(state), kernel_(kernel), in_every_step_(in_every_step) {}

  /// The stencil serves until stencil_strain: the slots are new, or what was found is not known.
  void clear();

  /// Decides which bodies need a look before a step of `time_step` [s]; whether there are any.
  bool is_due(double time_step);

  /// Adds what bodies strained in a step of `time_step` [s].
  void add_strain(const StageResults& results, double time_step);

  /// That look, over the blocks of all bodies; those that need none cost next to nothing.
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
