#pragma once

#include <functional>

#include "engine/output/results/frame.hpp"
#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// The particles of a state for viewers, with ghosts and surfaces as options; with ghosts, also the
/// pressure of contact walls, (RP.55). SI units; stresses have a zz component in plane strain too.
/// Surfaces are those of `find_nodes`: between remeshings, of a remeshed copy. `find_surroundings`
/// returns the walls and loads.
template <class T, int D>
Frame take_frame(const State<T, D>& state, const kernels::RemeshedTable<T, D>& kernels,
                 const NodeSource<T, D>& find_nodes,
                 const std::function<Surroundings<D>()>& find_surroundings,
                 const FrameParts& parts);

}  // namespace pliant::remeshed
