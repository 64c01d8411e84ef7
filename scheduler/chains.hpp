#pragma once

#include <vector>

#include "scheduler/dependencies.hpp"

namespace pliant::scheduler {

/// [node] The first node of its chain; most nodes are chains of their own.
///
/// A chain runs without interruption, which saves the overhead of oneTBB between its nodes (about
/// 0.2 us each). A node joins the chain of its only predecessor, unless that delays another
/// successor: all others must be at deeper levels, where they have to wait anyway. The level of a
/// node is the length of the longest path to it.
std::vector<int> chain_heads(const Dependencies& dependencies);

}  // namespace pliant::scheduler
