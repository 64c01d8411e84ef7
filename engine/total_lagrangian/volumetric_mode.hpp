#pragma once

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// q of (TL.23): the square of the ratio between the frequency of volume changes of the body's
/// cells and that of plane waves on the lattice. 1 inside a body; 2 across a bar of one cell and
/// 2.3 at its ends, 3 for a single cell, 1.4 at the corners of a box.
template <class T, int D>
double volumetric_mode_factor(const Body<T, D>& body);

extern template double volumetric_mode_factor(const Body<double, 2>&);
extern template double volumetric_mode_factor(const Body<double, 3>&);
extern template double volumetric_mode_factor(const Body<float, 2>&);
extern template double volumetric_mode_factor(const Body<float, 3>&);

}  // namespace pliant::total_lagrangian
