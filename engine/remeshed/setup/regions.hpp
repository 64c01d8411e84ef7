#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// The memory of a resource on a block of a step graph, for tests of declarations. Blocks are
/// numbered over all bodies; for groups on the new lattice (`new_state` to `record_numbers`), they
/// are blocks of that lattice. Vacant slots belong to the part of the particles.
///
/// Regions are valid until a phase extends a list, or until the next remeshing. Empty for data that
/// is private to the classes of phases: samples, sites, sums, results.
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
