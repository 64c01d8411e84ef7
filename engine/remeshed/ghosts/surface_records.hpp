#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Whether a stage computes grad phi of surface particles, and how long after it [s] (RP.61).
struct Slopes {
  bool are_renewed;
  double lead;
};

/// grad phi of the middle of a step serves all its stages. The stress turns from stage to stage,
/// though, so that the forces of the first two stages, if compared as in (RP.88), need grad phi of
/// their own times.
inline Slopes slopes_at(int stage, double time_step, bool first_two_are_compared) {
  if (first_two_are_compared) return {stage < 2, 0};
  return {stage == 0, time_step / 2};
}

/// Writes the records of a block's surface particles at a stage, for ghosts.
template <class T, int D>
void write_surface_records(Body<T, D>& body, int block, int stage, Slopes slopes,
                           const kernels::RemeshedTable<T, D>& kernels);

}  // namespace pliant::remeshed
