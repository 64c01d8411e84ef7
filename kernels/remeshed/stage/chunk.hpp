#pragma once

#include "kernels/law.hpp"
#include "kernels/marks.hpp"
#include "kernels/remeshed/stage/arguments.hpp"

namespace pliant::kernels {

/// Slots that a stage processes in all its loops before the next ones. Their rates stay in the
/// first cache, and each loop reads and writes few streams.
inline constexpr int chunk_slots = 64;

/// Slots first..first+count-1 of a segment, whole packs.
struct Chunk {
  std::int64_t first;
  int count;
};

/// Gradients of a chunk, zero in slots that are not interior.
template <class T, int D>
struct ChunkGradients {
  alignas(64) T velocity[D][D][chunk_slots];  ///< du_i/dx_j
  alignas(64) T force[D][chunk_slots];        ///< div sigma
  alignas(64) T drag[D][chunk_slots];         ///< du/dt of (RP.23)
};

/// Mask of the interior particles of a register.
template <class P>
inline auto interior_lanes(const Mark* interior, std::int64_t slot) {
  return load_marks<P>(interior + slot) > P(Scalar<P>(0.5));
}

/// Lanes in which x is a finite number.
template <class P>
inline auto finite_lanes(const P& x) {
  return (x - x) == P(Scalar<P>(0));
}

/// Stores the stress of a register of particles. In slots that are not interior, values that are
/// not finite become zero, since the extrapolated state may be impossible for the material.
template <Model model, class P, int D>
inline void store_stress(const Material<Scalar<P>>& material,
                         const P (&carried)[material_component_count<D>(model)], const P& density,
                         PackState state, const Mark* interior, std::int64_t slot,
                         Scalar<P>* const (&stress)[symmetric_components<D>]) {
  P sigma[symmetric_components<D>];
  Law<model, P, D>::stress(material, carried, density, sigma);
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) {
    if (state != PackState::all) {
      sigma[c] = xsimd::select(interior_lanes<P>(interior, slot) || finite_lanes(sigma[c]),
                               sigma[c], P(Scalar<P>(0)));
    }
    sigma[c].store_unaligned(stress[c] + slot);
  }
}

}  // namespace pliant::kernels
