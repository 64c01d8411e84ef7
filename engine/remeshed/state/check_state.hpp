#pragma once

#include <string>
#include <vector>

#include "engine/method/step_failure.hpp"
#include "engine/remeshed/state/stage_results.hpp"
#include "engine/remeshed/state/state.hpp"

/// Failures of a run that are found from its state.
namespace pliant::remeshed {

/// Advice of a method. It is a function because steps do not allocate; it is called after a
/// failure.
using Remedies = std::vector<std::string> (*)(const Case& settings);

/// Throws StepFailure when a particle is no longer finite.
template <class T, int D>
void check_finite(const Case& settings, const StageResults& results, const State<T, D>& state,
                  Remedies remedies);

/// Throws StepFailure when the strain of a body in a step of `time_step` [s] is so large that its
/// state is meaningless: the next neighbour lists would not fit into memory.
template <class T, int D>
void check_strain(const Case& settings, const StageResults& results, const State<T, D>& state,
                  double time_step, Remedies remedies);

/// Throws StepFailure when a body has no particles left. Between two remeshings, an unstable body
/// may leave its level set with finite values.
template <class T, int D>
void check_bodies(const Case& settings, const State<T, D>& state, Remedies remedies);

}  // namespace pliant::remeshed
