#pragma once

#include <array>
#include <pliant/field.hpp>
#include <vector>

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// The runs of slots that hold particles, in ascending order.
template <class T, int D>
std::vector<SlotRun> slot_runs(const Body<T, D>& body);

/// The fields as they are in memory.
template <class T, int D>
std::vector<FieldView> field_views(const Body<T, D>& body);

/// Positions of the particles [m], in the order of the slots; z = 0 in 2D.
template <class T, int D>
std::vector<std::array<double, 3>> present_positions(const Body<T, D>& body);

}  // namespace pliant::remeshed
