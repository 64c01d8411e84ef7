#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// The memory that belongs to a resource on a block of a step graph, to test declarations with.
/// Blocks are numbered over all bodies; those of groups on the new lattice (`new_state` to
/// `record_numbers`) are its own. Slots that hold nothing belong to the part of the particles.
///
/// Regions hold until the next phase that lets a list grow, and until the next remeshing. Empty for
/// what the classes of phases keep to themselves, one value for each block or body: samples, sites,
/// sums, results.
template <class T, int D>
std::vector<std::span<std::byte>> regions(State<T, D>& state, scheduler::FieldId resource,
                                          int block);

extern template std::vector<std::span<std::byte>> regions<double, 2>(State<double, 2>&,
                                                                     scheduler::FieldId, int);
extern template std::vector<std::span<std::byte>> regions<double, 3>(State<double, 3>&,
                                                                     scheduler::FieldId, int);
extern template std::vector<std::span<std::byte>> regions<float, 2>(State<float, 2>&,
                                                                    scheduler::FieldId, int);
extern template std::vector<std::span<std::byte>> regions<float, 3>(State<float, 3>&,
                                                                    scheduler::FieldId, int);

}  // namespace pliant::remeshed
