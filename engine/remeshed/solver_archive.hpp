#pragma once

#include "engine/output/archive.hpp"
#include "engine/remeshed/solver.hpp"

namespace pliant {

/// Everything that the next step reads: clock, walls, and of every body its layout, kinds, fields,
/// stress and ghost fits. A restored solver goes on to the same bits.
template <class T, int D>
void put_solver(ArchiveWriter& archive, remeshed::Solver<T, D>& solver);

/// Into a solver made from the same case. Throws OutputError when the archive does not fit it.
template <class T, int D>
void get_solver(const ArchiveReader& archive, remeshed::Solver<T, D>& solver);

}  // namespace pliant
