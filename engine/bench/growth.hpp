#pragma once

#include <string>
#include <vector>

#include "engine/bench/row.hpp"

/// How set-up time, memory and speed scale with the number of particles.
namespace pliant::bench {

/// Free bodies with 10^4, 10^5, ... particles, at most `largest`, in 2D and 3D, for each method
/// that does not need a mesh file.
std::vector<Row> growth_rows(std::int64_t largest, int threads);

/// Particles, set-up time, memory and speed, with one line for each row.
std::string growth_text(const std::vector<Row>& rows);
std::string growth_markdown(const std::vector<Row>& rows);

}  // namespace pliant::bench
