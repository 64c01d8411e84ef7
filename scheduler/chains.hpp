#pragma once

#include <vector>

#include "scheduler/dependencies.hpp"

namespace pliant::scheduler {

/// [node] The first node of the chain that it belongs to; most nodes are chains of their own.
///
/// A chain runs in one go, which spares oneTBB's work between its nodes (about 0.2 us each). A node
/// joins the chain of the only node that it waits for, unless that holds back another successor
/// which could have started at once: all others must lie at deeper levels (lengths of the longest
/// path that leads to a node), where they wait for something else anyway.
std::vector<int> chain_heads(const Dependencies& dependencies);

}  // namespace pliant::scheduler
