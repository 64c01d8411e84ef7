#pragma once

#include "engine/output/archive.hpp"
#include "engine/total_lagrangian/solver.hpp"

namespace pliant {

/// Everything that the next step reads and set-up does not make again.
template <class T, int D>
void put_solver(ArchiveWriter& archive, total_lagrangian::Solver<T, D>& solver);

/// Into a solver made from the same case. Throws OutputError when the archive does not fit it.
template <class T, int D>
void get_solver(const ArchiveReader& archive, total_lagrangian::Solver<T, D>& solver);

}  // namespace pliant
