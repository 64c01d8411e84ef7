#pragma once

#include "engine/output/archive.hpp"
#include "engine/output/frame.hpp"
#include "engine/total_lagrangian/solver.hpp"

namespace pliant {

/// The particles of a solver as viewers see them, in SI units. Stress, pressure and dilatation are
/// the means over the stress points around a particle. There are no ghosts to show.
template <class T, int D>
Frame take_frame(total_lagrangian::Solver<T, D>& solver, bool with_ghosts,
                 bool with_surface = false);

/// Everything that the next step reads and set-up does not make again.
template <class T, int D>
void put_solver(ArchiveWriter& archive, total_lagrangian::Solver<T, D>& solver);

/// Into a solver made from the same case. Throws OutputError when the archive does not fit it.
template <class T, int D>
void get_solver(const ArchiveReader& archive, total_lagrangian::Solver<T, D>& solver);

}  // namespace pliant
