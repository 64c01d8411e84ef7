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

/// A failure at a time and step: what happened, and at least one remedy to try. If the step of the
/// case exceeds the stability limit, the message names that as the cause, with its own remedy.
StepFailure failed_step(const Case& settings, const StepClock& clock, const std::string& what,
                        const std::vector<std::string>& remedies);

/// The remedy of a smaller time step, with the key that sets the step of this case.
std::string smaller_step(const Case& settings);

/// A place as failure messages print it: "(x, y)" or "(x, y, z)" [m].
template <int D>
std::string coordinates(const Point<D>& x);

}  // namespace pliant
