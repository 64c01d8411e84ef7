#pragma once

#include <stdexcept>

namespace pliant {

/// The run cannot go on: the state is not finite, or the time step has collapsed.
struct StepFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace pliant
