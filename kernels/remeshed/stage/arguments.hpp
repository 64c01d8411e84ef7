#pragma once

#include <array>
#include <cstdint>

#include "kernels/isa.hpp"
#include "kernels/layout.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshed/evolving.hpp"
#include "kernels/remeshed/stage/gradient.hpp"

/// Arguments of the kernels of a Runge-Kutta stage.
namespace pliant::kernels {

/// Neighbour lists, for neighbours beyond the stencil: one for each pack, padded to its longest
/// lane with the particle itself, which adds nothing. Entry k of lane l of pack i is at start[i] +
/// k * pack + l.
template <int D>
struct NeighbourLists {
  const std::int64_t* start;      ///< [pack]
  const std::int32_t* length;     ///< [pack]
  const std::int32_t* neighbour;  ///< slot
  std::array<const std::int32_t*, D>
      offset;  ///< from the particle to the neighbour [cells], including whole periods between them
};

/// The update of one p_i of (RP.10) by a stage, (RP.22): decay p_i + start (J - 1) + end (J - 1),
/// with p_i and the first J at the start of the step, and the second J at the new state.
template <class T>
struct Relaxation {
  T decay;  ///< 1
  T start;  ///< [Pa]
  T end;    ///< [Pa]
};

/// The p_i of a body; a body without Prony terms has none.
template <class T>
struct BulkViscosity {
  int terms = 0;
  const Relaxation<T>* relaxation = nullptr;  ///< [term], for a stage
  T* const* pressure = nullptr;               ///< [term][slot] p_i at the start of the step [Pa]
  T* volume_change = nullptr;  ///< [slot] J - 1 at the start; the first stage stores it
};

/// What the pair forces of plain SPH need besides the state, (RP.26).
template <class T, int D>
struct SymmetricPairs {
  std::array<const T*, symmetric_components<D>> stress;      ///< sigma/rho^2
  std::array<const T*, symmetric_components<D>> artificial;  ///< R of (RP.28)
  T linear, quadratic;  ///< alpha c [m/s] and beta [1] of (RP.27)
};

/// One Runge-Kutta stage of one block, (RP.13) by (RP.20) or (RP.19) and (RP.21): gradients of
/// velocity and stress, rates, update, and the stress of the new state.
///
/// Reads drift, velocity and stress of `current` also in neighbouring blocks; for (RP.19) the
/// volume too. Writes `next` and `next_stress` in packs with interior particles. Their other slots
/// get zero rates, except for the drift, which follows their velocity. In packs of ghosts only the
/// drift is written, in vacant packs nothing. Three copies of the state serve all stages: in stage
/// 2 `next` may be `second`, in stage 3 (the last) `start`. The drift has two: those of `current`
/// and `next` alternate, and `start` has that of even stages.
template <class T, int D>
struct Stage {
  const Segment<D>* segments;
  int segment_count;
  T spacing;
  T time_step;
  T velocity_dissipation;  ///< kappa_u of (RP.23) [1/s]; 0: none
  T restoring_rate;        ///< r of (RP.23) [1/s]; 0: none
  T stress_dissipation;    ///< kappa_sigma of (RP.23) [1/s]; 0: none
  bool relaxes_shear;      ///< with the mean stress, in 2D, (RP.23)
  int stage;               ///< 0..3
  Kernel kernel;
  Gradient gradient;
  Material<T> material;
  const PackState* pack_state;          ///< [slot / slots_per_pack]
  const Mark* interior;                 ///< [slot], 1 for interior particles, else 0
  const NeighbourLists<D>* neighbours;  ///< nullptr: use the stencil
  const T* mass;
  Evolving<const T, D> current;  ///< Q of this stage
  std::array<const T*, symmetric_components<D>> stress;
  Evolving<T, D> start;         ///< Q0; stage 2 leaves Q3 + (Q2 - Q0)/3 there
  Evolving<const T, D> second;  ///< Q2 without the drift, read in stage 2
  Evolving<const T, D> third;   ///< Q3 without the drift, read in stage 3
  Evolving<T, D> next;
  std::array<T*, symmetric_components<D>> next_stress;
  BulkViscosity<T> viscosity = {};  ///< the last stage writes its pressures
  /// nullptr: use `gradient`; else plain SPH with neighbour lists, which reads the stress from
  /// here.
  const SymmetricPairs<T, D>* pairs = nullptr;
};

/// Largest values over the interior particles of a block.
struct StageResult {
  double strain_rate = 0;        ///< max abs(eps)_F of (RP.39) [1/s], at the stage's state
  double deformation = 0;        ///< max abs(F - I)_F of (RP.39), at the stage's state
  double wave_speed = 0;         ///< max c of (RP.12) [m/s], at the new state
  std::int64_t non_finite = -1;  ///< a slot whose new state is not finite or has v <= 0, or -1
};

/// Computes sigma of (RP.2) from a state, in every slot of a block; returns the wave speed.
template <class T, int D>
struct StressOfState {
  const Segment<D>* segments;
  int segment_count;
  Material<T> material;
  const PackState* pack_state;
  const Mark* interior;
  const T* mass;
  Evolving<const T, D> state;
  std::array<T*, symmetric_components<D>> stress;
  BulkViscosity<T> viscosity = {};
};

/// A vector field on the lattice, of which lattice_gradient computes the largest abs(grad f)_F over
/// the interior particles of a block, from differences between interior particles.
template <class T, int D>
struct LatticeField {
  const Segment<D>* segments;
  int segment_count;
  T spacing;
  const PackState* pack_state;
  const Mark* interior;
  std::array<const T*, D> field;
};

template <class T, int D>
struct StageKernels {
  StageResult (*advance_stage)(const Stage<T, D>&);
  StageResult (*evaluate_stress)(const StressOfState<T, D>&);
  double (*lattice_gradient)(const LatticeField<T, D>&);
};

template <Isa isa, class T, int D>
StageKernels<T, D> stage_kernels();

}  // namespace pliant::kernels
