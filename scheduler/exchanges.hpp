#pragma once

#include <vector>

#include "scheduler/phase.hpp"

namespace pliant::scheduler {

/// The phases with an exchange before each phase that reads values of other blocks, for the fields
/// that no exchange has sent since they were written or since the start of the list.
///
/// What a reduce phase reads and writes needs no exchange: it gathers and spreads by itself.
std::vector<Phase> with_exchanges(std::vector<Phase> phases);

}  // namespace pliant::scheduler
