#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scheduler/access_probe.hpp"

namespace pliant::scheduler {

/// For example "phase advance[0] on block 2 reads velocity of block 5 without declaring it".
std::string text(const UndeclaredAccess& access);

/// Undeclared reads and writes of phases, each (phase, field) once.
///
/// `experiment(probe)` must do the same each time: set up its own state, let the probe watch the
/// workers, and run steps. It is called several times.
///
/// A write is found by comparing memory before and after each node. A read is found by its effect:
/// all values that a node has not declared are disturbed while it runs, and its writes must stay
/// bitwise the same. A value that is loaded but not used does not count as read. Works in every
/// build.
///
/// Throws what the experiment throws when nothing is disturbed.
std::vector<UndeclaredAccess> undeclared_accesses(
    const std::function<void(AccessProbe& probe)>& experiment);

}  // namespace pliant::scheduler
