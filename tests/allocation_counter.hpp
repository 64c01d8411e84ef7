#pragma once

#include <algorithm>
#include <climits>

namespace pliant::test {

/// Allocations so far by code of the program: operator new, and aligned_alloc, by which arrays
/// grow. (oneTBB takes its tasks from malloc.) Linking it replaces both.
int allocations();

/// The least number of them in any of several stretches. A worker makes room for itself when it
/// first takes part, which may be late; what allocates for good does so in each.
template <class Stretch>
int least_allocations(const Stretch& stretch) {
  int least = INT_MAX;
  for (int i = 0; i < 20 && least > 0; ++i) {
    const int before = allocations();
    stretch();
    least = std::min(least, allocations() - before);
  }
  return least;
}

}  // namespace pliant::test
