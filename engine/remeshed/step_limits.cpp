#include "engine/remeshed/step_limits.hpp"

#include <algorithm>

// (RP.30). A plane wave of the wave number k has the rates lambda = -kappa delta^4(k) +- i c g(k),
// where g(k) is the response of the gradient operator. Runge-Kutta 4 is stable up to 2 sqrt(2) on
// the imaginary axis and up to 2.785 on the real one.
namespace pliant::remeshed {

namespace {

constexpr double on_imaginary_axis = 2.8284271247461903, on_real_axis = 2.785;
// Free surfaces and walls need shorter steps than the interior, as measured.
constexpr double near_surfaces = 0.75;

/// max_k h abs(g(k)) on the square and on the cubic lattice.
double largest_response(kernels::Kernel kernel, int dimension) {
  const bool plane = dimension == 2;
  switch (kernel) {
    case kernels::Kernel::quartic_spline:
      return plane ? 0.951 : 0.971;
    case kernels::Kernel::quartic_spline_fit:
      return plane ? 0.920 : 0.946;
    case kernels::Kernel::compact:
      return plane ? 1.251 : 1.400;
    case kernels::Kernel::fourth_order:
      return plane ? 1.727 : 2.143;
  }
  return 1;
}

}  // namespace

StepLimits step_limits(const Case& a_case, double default_cfl) {
  const auto& discretisation = a_case.discretisation;
  const double waves =
      on_imaginary_axis / largest_response(discretisation.kernel, a_case.dimension);
  // delta^4 is at most 16 along each direction, which cancels the 16 in the denominator of kappa.
  const double dissipation =
      std::max(discretisation.dissipation.velocity, discretisation.dissipation.stress) *
      a_case.dimension;
  StepLimits limits;
  limits.stable_cfl =
      near_surfaces * (dissipation > 0 ? std::min(waves, on_real_axis / dissipation) : waves);
  limits.default_cfl = default_cfl;
  limits.bounds_given_steps = true;
  return limits;
}

}  // namespace pliant::remeshed
