#pragma once

#include <array>

#include "engine/case/case.hpp"

namespace pliant::remeshed {

/// What a particle carries at t = 0.
template <int D>
struct InitialState {
  std::array<double, D* D> material = {};  ///< S [Pa] or F
  double density = 0;                      ///< [kg/m^3]
};

/// The state at `x` of a body that starts with an initial stress: S and the density of its pressure
/// (linear), or the stretch whose stress it is (reduced polynomial), (RP.77). Throws InputError
/// where there is none.
template <int D>
InitialState<D> state_under_stress(const BodyCase& body, const Vector& x);

extern template InitialState<2> state_under_stress<2>(const BodyCase&, const Vector&);
extern template InitialState<3> state_under_stress<3>(const BodyCase&, const Vector&);

}  // namespace pliant::remeshed
