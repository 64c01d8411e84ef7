#pragma once

#include <array>
#include <pliant/field.hpp>
#include <vector>

#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// The runs of slots that hold nodes, in ascending order.
template <class T, int D>
std::vector<SlotRun> slot_runs(const Body<T, D>& body);

/// Positions of the nodes [m], in the order of the slots; z = 0 in 2D.
template <class T, int D>
std::vector<std::array<double, 3>> present_positions(const Body<T, D>& body);

}  // namespace pliant::point_based
