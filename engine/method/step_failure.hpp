#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/method/step_clock.hpp"

namespace pliant {

/// The run cannot continue: the state is not finite, or the time step has collapsed.
struct StepFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A failure with its time and step: `what` happened, and the remedies to try, of which there is at
/// least one. Where the case has a step above the stability limit, that is the cause, and the
/// remedy is another step.
StepFailure failed_step(const Case& settings, const StepClock& clock, const std::string& what,
                        const std::vector<std::string>& remedies);

/// The remedy of a smaller time step, by the key that sets the step of this case.
std::string smaller_step(const Case& settings);

/// A place as failures name it: "(x, y)" or "(x, y, z)" [m].
template <int D>
std::string coordinates(const Point<D>& x);

}  // namespace pliant
