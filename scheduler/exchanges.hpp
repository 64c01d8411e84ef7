#pragma once

#include <vector>

#include "scheduler/phase.hpp"

namespace pliant::scheduler {

/// Inserts an exchange before each phase that reads values of other blocks. It covers the fields
/// that no exchange has sent since they were written or since the start of the list.
///
/// A reduce phase needs no exchange: it gathers and distributes its values itself.
std::vector<Phase> with_exchanges(std::vector<Phase> phases);

}  // namespace pliant::scheduler
