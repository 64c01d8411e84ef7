#pragma once

#include "engine/finite_elements/state.hpp"
#include "engine/point_based/regions.hpp"

namespace pliant::finite_elements {

/// The memory of a resource on a block of the step graph, for tests of declarations. Empty for the
/// results, which are private to the step.
template <class T, int D>
std::vector<point_based::Region> regions(State<T, D>& state, scheduler::FieldId resource,
                                         int block);

extern template std::vector<point_based::Region> regions<double, 2>(State<double, 2>&,
                                                                    scheduler::FieldId, int);
extern template std::vector<point_based::Region> regions<double, 3>(State<double, 3>&,
                                                                    scheduler::FieldId, int);

}  // namespace pliant::finite_elements
