#pragma once

#include <vector>

#include "engine/boundaries/boundary_values.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/remeshed/state.hpp"

namespace pliant::remeshed {

/// (RP.65) of the walls to which bodies are attached and that are `watched`: adds their push on a
/// block during `duration` [s] to impulse[wall] and their work to the budget, from the records of
/// the surface particles.
template <class T, int D>
void add_wall_work(const Body<T, D>& body, int block, const Boundaries<D>& boundaries,
                   const BoundaryValues<D>& values, const std::vector<char>& watched,
                   double duration, const kernels::RemeshedTable<T, D>& kernels, Point<D>* impulse,
                   EnergyBudget& budget);

}  // namespace pliant::remeshed
