#pragma once

#include <vector>

#include "engine/remeshed/state.hpp"
#include "kernels/material.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// Strain after which slots from outside the stencil may come into the support, (RP.47): 0.16, with
/// the compact weight 0.12.
double stencil_strain(kernels::Weight weight);

/// Finds the neighbours of particles in space, once bodies have strained so much since their last
/// remeshing that the stencil may miss some, and again before what was found may miss some.
///
///     cells        each block notes where its particles and ghosts are; then they are sorted into
///                  a cell list for each body
///     neighbours   each block lists its particles' neighbours, if some are outside the stencil
///
/// Sums over lists have the bits of sums over the stencil, and do not depend on when the lists were
/// made: they run in the order of the stencil, and what lies outside the support adds zeros. What
/// a search finds is therefore no part of the state, and no checkpoint holds it.
template <class T, int D>
class NeighbourSearch {
 public:
  NeighbourSearch(State<T, D>& state, kernels::Weight weight) : state_(state), weight_(weight) {}

  /// Decides which bodies must be searched before a step of `time_step` [s], by (RP.47) and
  /// (RP.48); whether there are any.
  bool is_due(double time_step);

  /// The search, over the blocks of all bodies; those that need none cost next to nothing.
  std::vector<scheduler::Phase> phases();

 private:
  void find_sites(int block);
  void sort_sites();
  void list_neighbours(int block);

  State<T, D>& state_;
  kernels::Weight weight_;
};

extern template class NeighbourSearch<double, 2>;

}  // namespace pliant::remeshed
