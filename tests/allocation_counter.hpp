#pragma once

namespace pliant::test {

/// Allocations so far by code of the program: operator new, and aligned_alloc, by which arrays
/// grow. (oneTBB takes its tasks from malloc.) Linking it replaces both.
int allocations();

}  // namespace pliant::test
