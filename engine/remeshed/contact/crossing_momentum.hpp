#pragma once

#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::remeshed {

/// What the momentum of a body shows of its contacts in a step.
template <int D>
struct MomentumGain {
  bool is_free;     ///< nothing but contacts and body forces changes it
  Point<D> gained;  ///< besides that of body forces [N s]
};

/// (RP.104): corrects impulses of contacts on their second bodies [N s]. Tractions times areas do
/// not add up to what ghosts transfer to the particles: areas at edges are uncertain. Where a body
/// is held, the change of its momentum does not show what crosses a contact, but that of a free
/// body on it does. `impulses` that are 0 stay.
template <int D>
void follow_free_bodies(const std::vector<ContactCase>& contacts,
                        const std::vector<MomentumGain<D>>& bodies,
                        std::vector<Point<D>>& impulses);

}  // namespace pliant::remeshed
