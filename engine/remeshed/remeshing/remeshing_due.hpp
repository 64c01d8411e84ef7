#pragma once

#include "engine/case/case.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// Whether the policy of a case, `remeshing.policy`, requires a remeshing at the end of a step:
/// (RP.39), in contact (RP.96), and of bodies that swing (RP.108).
template <class T, int D>
bool remeshing_is_due(const Case& settings, const State<T, D>& state);

}  // namespace pliant::remeshed
