#pragma once

#include "kernels/table.hpp"

namespace pliant::kernels {

/// One for each instruction set, defined in the unit that is compiled for it.
template <int D>
const Table<double, D>& sse2_table();
template <int D>
const Table<double, D>& avx2_table();
template <int D>
const Table<double, D>& avx512_table();

}  // namespace pliant::kernels
