#pragma once

#include <array>

#include "kernels/layout.hpp"

namespace pliant::kernels {

/// Fields that the Runge-Kutta method advances: xi, u, v and S or F. `drift` is the drift
/// from the slot since the last remeshing, so that x_p = (cell + 1/2 + lattice offset) h + xi_p.
template <class T, int D>
struct Evolving {
  std::array<T*, D> drift;
  std::array<T*, D> velocity;
  T* volume;
  std::array<T*, material_components<D>> material;  ///< S in the order of symmetric_index, or F
};

}  // namespace pliant::kernels
