#pragma once

#include "engine/output/archive.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// Everything that the next step reads and set-up does not make again.
template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state);

/// Into the state of the same case. Throws OutputError when the archive does not fit it.
template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state);

}  // namespace pliant::point_based
