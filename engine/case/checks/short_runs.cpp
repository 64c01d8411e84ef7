#include "engine/case/checks/short_runs.hpp"

#include <fmt/format.h>

#include "engine/case/checks/stability.hpp"

namespace pliant {

// Measured for blocks between pistons: flanks that begin to bulge deviate by 1.3/n^2, with kernels
// of 5 x 5 particles by 1.6/n^2, after waves have passed through n spacings.
void warn_of_short_runs(const Case& a_case, std::vector<std::string>& warnings) {
  constexpr double enough = 6;  // spacings, 4 %
  const double way = fastest_wave(a_case) * a_case.time.end;
  const double spacings = way / a_case.discretisation.spacing;
  if (a_case.boundaries.empty() || !(spacings < enough)) return;
  warnings.push_back(fmt::format(
      "waves pass through no more than {:.2g} spacings until the run ends: displacements that "
      "begin with it deviate by 5 % or more; use a finer spacing (discretisation.spacing = {:.3g} "
      "or below)",
      spacings, way / enough));
}

}  // namespace pliant
