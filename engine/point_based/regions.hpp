#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/point_based/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::point_based {

struct Region {
  std::span<std::byte> bytes;
  bool are_numbers;  ///< in the precision of the state; else integers
};

/// The memory of a resource on a block of the step graph, for tests of declarations. Empty for the
/// results, which are private to the step.
template <class T, int D>
std::vector<Region> regions(State<T, D>& state, scheduler::FieldId resource, int block);

extern template std::vector<Region> regions<double, 2>(State<double, 2>&, scheduler::FieldId, int);
extern template std::vector<Region> regions<double, 3>(State<double, 3>&, scheduler::FieldId, int);

}  // namespace pliant::point_based
