#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/total_lagrangian/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::total_lagrangian {

/// The memory of a resource on a block of the step graph, for tests of declarations. Empty for the
/// results, which are private to the step.
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

}  // namespace pliant::total_lagrangian
