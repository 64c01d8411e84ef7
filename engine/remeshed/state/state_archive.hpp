#pragma once

#include "engine/output/archive/archive.hpp"
#include "engine/remeshed/remeshing/remeshings.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// Writes everything that the next step reads: clock, walls, and for every body its layout, kinds,
/// fields, stress and ghost fits.
template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state);

/// Reads into the state of the same case; `remeshings` builds the layouts of its bodies. Throws
/// OutputError when the archive does not fit the state.
template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state, Remeshings<T, D>& remeshings);

}  // namespace pliant::remeshed
