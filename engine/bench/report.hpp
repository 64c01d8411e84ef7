#pragma once

#include "engine/bench/row.hpp"

namespace pliant::bench {

/// Rates, and their shares of the machine's rates, with one line for each row.
std::string speed_table(const std::vector<Row>& rows);

/// Thread time per particle-stage [ns] by kinds of phases, with one line for each row.
std::string phase_table(const std::vector<Row>& rows);

/// All figures, with every phase, one line for each row; comment lines describe the machine.
std::string csv(const std::vector<std::string>& machine, const std::vector<Row>& rows);

}  // namespace pliant::bench
