#pragma once

#include <functional>

#include "engine/output/results/frame.hpp"
#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// The particles of a state as viewers see them, ghosts and surfaces as an option; with ghosts and
/// contact walls the pressure of these too, (RP.55). SI units; stresses have their zz component in
/// plane strain too. Surfaces are those of `find_nodes`: between remeshings, of a remeshed copy.
/// `find_surroundings` tells what acts on the bodies.
template <class T, int D>
Frame take_frame(const State<T, D>& state, const kernels::RemeshedTable<T, D>& kernels,
                 const NodeSource<T, D>& find_nodes,
                 const std::function<Surroundings<D>()>& find_surroundings,
                 const FrameParts& parts);

}  // namespace pliant::remeshed
