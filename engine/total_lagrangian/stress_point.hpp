#pragma once

#include <array>

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// One stress point in plain numbers, for measurements and output.
template <int D>
struct StressPoint {
  std::array<Point<D>, D> deformation_gradient = {};  ///< F
  double volume = 0;                                  ///< of the undeformed body [m^D]
  double volume_ratio = 1;                            ///< J
  double pressure = 0;                                ///< [Pa]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< sigma [Pa]
  double energy = 0;  ///< of the cell, with hourglass modes and Prony terms [J]
};

/// Undeformed place of the stress point above `slot`: the mean of the part in the body [m].
template <class T, int D>
Point<D> stress_point_place(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell);

/// The stress point above `slot`, (TL.2)-(TL.6); the body must fill some of its cell. With `ahead`
/// [s], particles are first advanced by that time at their velocities.
template <class T, int D>
StressPoint<D> stress_point(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell,
                            double ahead = 0);

}  // namespace pliant::total_lagrangian
