#pragma once

#include "engine/bench/row.hpp"

namespace pliant::bench {

/// Rates and shares of the machine's rates, a line each row.
std::string speed_table(const std::vector<Row>& rows);

/// Thread time per particle-stage [ns] by kinds of phases, a line each row.
std::string phase_table(const std::vector<Row>& rows);

/// Everything, the phases one by one, a line each row; comment lines describe the machine.
std::string csv(const std::vector<std::string>& machine, const std::vector<Row>& rows);

}  // namespace pliant::bench
