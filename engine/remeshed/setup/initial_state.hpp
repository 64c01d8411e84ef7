#pragma once

#include <array>

#include "engine/case/case.hpp"

namespace pliant::remeshed {

/// The material state of a particle at t = 0.
template <int D>
struct InitialState {
  std::array<double, D* D> material = {};  ///< S [Pa] or F
  double density = 0;                      ///< [kg/m^3]
};

/// The state at `x` of a body with an initial stress, (RP.77): S and the density of its pressure
/// (linear), or the stretch with this stress (reduced polynomial). Throws InputError if there is
/// none.
template <int D>
InitialState<D> state_under_stress(const BodyCase& body, const Vector& x);

extern template InitialState<2> state_under_stress<2>(const BodyCase&, const Vector&);
extern template InitialState<3> state_under_stress<3>(const BodyCase&, const Vector&);

}  // namespace pliant::remeshed
