#pragma once

namespace pliant::bench {

/// Share of its own time by which each measured step is made longer: 0, but in the program of
/// bench/comparison, which shows that comparisons find it.
double handicap();

}  // namespace pliant::bench
