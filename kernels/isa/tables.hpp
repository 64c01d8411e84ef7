#pragma once

#include "kernels/table.hpp"

namespace pliant::kernels {

/// One for each instruction set, defined in the unit that is compiled for it.
extern const Table<double, 2> sse2_table;
extern const Table<double, 2> avx2_table;
extern const Table<double, 2> avx512_table;

}  // namespace pliant::kernels
