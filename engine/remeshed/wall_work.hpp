#pragma once

#include <vector>

#include "engine/method/energy_budget.hpp"
#include "engine/remeshed/state.hpp"
#include "engine/remeshed/surroundings.hpp"

namespace pliant::remeshed {

/// How much larger the part of a wall that ghost g stands for is now than at the remeshing,
/// (RP.65): abs(cof F n), F of the places of the slots around in copy `buffer` of the state.
template <class T, int D>
double growth_on_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                      int buffer);

/// (RP.65) of the walls to which bodies are attached and that are `watched`: adds their push on a
/// block during `duration` [s] to impulse[wall] and their work to the budget, from the records of
/// the surface particles and the places of the slots in copy `buffer` of the state.
template <class T, int D>
void add_wall_work(const Body<T, D>& body, int block, int buffer, const Surroundings<D>& around,
                   const std::vector<char>& watched, double duration,
                   const kernels::RemeshedTable<T, D>& kernels, Point<D>* impulse,
                   EnergyBudget& budget);

}  // namespace pliant::remeshed
