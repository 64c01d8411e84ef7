#pragma once

#include <string>
#include <vector>

#include "engine/method/step_failure.hpp"
#include "engine/remeshed/state/stage_results.hpp"
#include "engine/remeshed/state/state.hpp"

/// Failures of a run that only its state shows.
namespace pliant::remeshed {

/// What a method advises: called when a run has failed, since a step allocates nothing.
using Remedies = std::vector<std::string> (*)(const Case& settings);

/// Throws StepFailure when a particle is no longer finite.
template <class T, int D>
void check_finite(const Case& settings, const StageResults& results, const State<T, D>& state,
                  Remedies remedies);

/// Throws StepFailure when a body has strained so much in a step of `time_step` [s] that its state
/// has no meaning: the lists of neighbours for the next step would not fit into memory.
template <class T, int D>
void check_strain(const Case& settings, const StageResults& results, const State<T, D>& state,
                  double time_step, Remedies remedies);

/// Throws StepFailure when a body has no particle left: within one remeshing, an unstable body may
/// leave its level set although all its values are finite.
template <class T, int D>
void check_bodies(const Case& settings, const State<T, D>& state, Remedies remedies);

}  // namespace pliant::remeshed
