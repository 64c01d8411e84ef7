#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scheduler/access_probe.hpp"

namespace pliant::scheduler {

/// "phase advance[0] on block 2 reads velocity of block 5 without declaring it".
std::string text(const UndeclaredAccess& access);

/// What phases read and write beyond their declarations, each (phase, field) once.
///
/// `experiment(probe)` must do the same each time: set up a state of its own, let the probe watch
/// the workers, and run steps. It is called several times.
///
/// A write is found by comparing memory before and after each node. A read is found by its effect:
/// all values that a node has not declared are disturbed while it runs, and what it writes must
/// stay bitwise the same. A value that is loaded but not used is no read. Works in every build.
///
/// Throws what the experiment throws when nothing is disturbed.
std::vector<UndeclaredAccess> undeclared_accesses(
    const std::function<void(AccessProbe& probe)>& experiment);

}  // namespace pliant::scheduler
