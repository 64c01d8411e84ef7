#pragma once

#include "engine/finite_elements/state.hpp"
#include "engine/point_based/regions.hpp"

namespace pliant::finite_elements {

/// The memory that belongs to a resource on a block of the step graph, to test declarations with.
/// Empty for the results, which the step keeps to itself.
template <class T, int D>
std::vector<point_based::Region> regions(State<T, D>& state, scheduler::FieldId resource,
                                         int block);

extern template std::vector<point_based::Region> regions<double, 2>(State<double, 2>&,
                                                                    scheduler::FieldId, int);
extern template std::vector<point_based::Region> regions<double, 3>(State<double, 3>&,
                                                                    scheduler::FieldId, int);

}  // namespace pliant::finite_elements
