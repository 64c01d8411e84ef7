#pragma once

namespace pliant::bench {

/// The share of its own time by which each measured step is prolonged. It is 0 except in the
/// program of bench/comparison, which shows that comparisons detect it.
double handicap();

}  // namespace pliant::bench
