#pragma once

#include <algorithm>
#include <climits>

namespace pliant::test {

/// Allocations so far by code of the project: operator new, and aligned_alloc, with which arrays
/// grow. (oneTBB allocates tasks with malloc.) Linking this file replaces both functions.
int allocations();

/// The minimum number of allocations in several stretches. A worker allocates when it first takes
/// part, which may be late; code that always allocates does so in each stretch.
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
