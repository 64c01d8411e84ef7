#include "engine/bench/handicap.hpp"

namespace pliant::bench {

double handicap() { return 0; }

}  // namespace pliant::bench
