#pragma once

#include <array>
#include <cstdint>

#include "kernels/evolving.hpp"
#include "kernels/fit_terms.hpp"
#include "kernels/isa.hpp"
#include "kernels/layout.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshing.hpp"
#include "kernels/total_lagrangian.hpp"

/// The kernels as the engine calls them: one table of functions for each instruction set, each
/// function working on one block of slots. Kernels never allocate, throw, print, or keep state.
/// What the kernels of remeshing and of the total Lagrangian method work on is in files of its own.
namespace pliant::kernels {

/// Neighbours beyond the reach of the stencil: a list for each pack, padded to its longest lane
/// with the particle itself (which adds nothing). Entry k of lane l of pack i: start[i] + k * pack
/// + l.
template <int D>
struct NeighbourLists {
  const std::int64_t* start;                  ///< [pack]
  const std::int32_t* length;                 ///< [pack]
  const std::int32_t* neighbour;              ///< slot
  std::array<const std::int32_t*, D> offset;  ///< from the particle to the neighbour [cells], with
                                              ///< the whole periods that lie between them
};

/// What a stage makes of one p_i of (RP.70): decay p_i + start (J - 1) + end (J - 1), p_i and the
/// first J at the start of the step, the second J at the new state, (RP.71).
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
  const Relaxation<T>* relaxation = nullptr;  ///< [term], of a stage
  T* const* pressure = nullptr;               ///< [term][slot] p_i at the start of the step [Pa]
  T* volume_change = nullptr;                 ///< [slot] J - 1 there: the first stage keeps it
};

/// What particles need besides their state for the pair forces of plain SPH, (RP.74).
template <class T, int D>
struct SymmetricPairs {
  std::array<const T*, symmetric_components<D>> stress;      ///< sigma/rho^2
  std::array<const T*, symmetric_components<D>> artificial;  ///< R of (RP.76)
  T linear, quadratic;  ///< alpha c [m/s] and beta [1] of (RP.75)
};

/// One Runge-Kutta stage of one block, (RP.12) by (RP.18) and (RP.19): gradients of velocity and
/// stress, rates, update, and the stress of the new state.
///
/// Reads drift, velocity and stress of `current` also in neighbouring blocks. Writes `next`
/// and `next_stress` in packs with interior particles; their other slots get zero rates but for the
/// drift, which follows their velocity. In packs of ghosts the displacement alone is
/// written, in vacant ones nothing. Three copies of the state serve all stages: in stage 2 `next`
/// may be `second`, in stage 3 (the last) `start`.
template <class T, int D>
struct Stage {
  const Segment<D>* segments;
  int segment_count;
  T spacing;
  T time_step;
  T dissipation;  ///< kappa of (RP.43) [1/s]; 0: none
  int stage;      ///< 0..3
  Weight weight;
  Material<T> material;
  const PackState* pack_state;          ///< [slot / slots_per_pack]
  const T* interior;                    ///< [slot], 1 for interior particles, else 0
  const NeighbourLists<D>* neighbours;  ///< nullptr: the stencil
  const T* mass;
  Evolving<const T, D> current;  ///< Q of this stage
  std::array<const T*, symmetric_components<D>> stress;
  Evolving<T, D> start;         ///< Q0; stage 2 leaves Q3 + (Q2 - Q0)/3 there
  Evolving<const T, D> second;  ///< Q2, read in stage 2
  Evolving<const T, D> third;   ///< Q3, read in stage 3
  Evolving<T, D> next;
  std::array<T*, symmetric_components<D>> next_stress;
  BulkViscosity<T> viscosity = {};  ///< the last stage writes its pressures
  /// nullptr: the moment-matrix gradient; else plain SPH, whose neighbours are listed and which
  /// reads stress from here.
  const SymmetricPairs<T, D>* pairs = nullptr;
};

/// Largest values over the interior particles of a block.
struct StageResult {
  double strain_rate;       ///< max abs(eps)_F of (RP.28) [1/s], at the stage's state
  double wave_speed;        ///< max c of (RP.11) [m/s], at the new state
  std::int64_t non_finite;  ///< a slot whose new state is not finite or has v <= 0, or -1
};

/// sigma of (RP.2) from a state, in every slot of a block; the wave speed in the result.
template <class T, int D>
struct StressOfState {
  const Segment<D>* segments;
  int segment_count;
  Material<T> material;
  const PackState* pack_state;
  const T* interior;
  const T* mass;
  Evolving<const T, D> state;
  std::array<T*, symmetric_components<D>> stress;
  BulkViscosity<T> viscosity = {};
};

/// Where the fields of a surface particle's record lie: first what all fits of a ghost of the free
/// surface ask for. Padded with zeros, u to whole registers of four doubles, all to cache lines of
/// eight.
template <int D>
struct RecordPlace {
  static constexpr int stress = 0;                             ///< sigma
  static constexpr int pressure = symmetric_components<D>;     ///< p
  static constexpr int velocity = (pressure + 1 + 3) / 4 * 4;  ///< u (D)
  static constexpr int slope = velocity + D;                   ///< grad phi (D)
};
template <int D>
inline constexpr int record_width = (RecordPlace<D>::slope + D + 7) / 8 * 8;

/// A pack of slots of which some are surface particles.
struct SurfacePack {
  std::int64_t first;    ///< slot
  std::int32_t segment;  ///< of the block
  std::int32_t record;   ///< of the first surface particle in the pack; the others follow by lane
  std::uint16_t lanes;   ///< bit l: lane l is a surface particle
};

/// Writes the records of one block's surface particles, grad phi by (RP.81).
template <class T, int D>
struct SurfaceRecords {
  const Segment<D>* segments;
  const SurfacePack* packs;
  int pack_count;
  T spacing;
  Material<T> material;
  const T* mass;
  const T* level_set;
  Evolving<const T, D> state;
  std::array<const T*, symmetric_components<D>> stress;
  T* records;            ///< [record][record_width]
  bool relaxes = false;  ///< whether the stress holds the p_i of (RP.70) too
};

/// For ghosts first..first+count-1 and their neighbours i: sums[g][0][k] = sum_i c_gi record_i[k]
/// by (RP.32), sums[g][1][k] = sum_i b_gi record_i[k] by (RP.33), sums[g][2][k] = sum_i a_gi
/// record_i[k], the fit (RP.32) at the foot point.
template <class T, int D>
struct GhostSums {
  std::int64_t first;
  std::int64_t count;
  const std::int64_t* begin;       ///< [ghost + 1] into pairs
  const FitPair* pairs;            ///< with neighbours; whole registers of them are loaded
  const FitTerms<T, D>* terms;     ///< [ghost]
  const std::int64_t* wall_begin;  ///< [ghost] into wall_distance; -1 at free surfaces
  const T* wall_distance;          ///< of the neighbours, over h; loaded as the pairs are
  const T* surface_distance;       ///< [record] over h
  const T* records;                ///< [record][record_width]
  T* sums;                         ///< [ghost - first][3][record_width]
};

/// Velocity and stress of ghosts by (RP.34), (RP.44); those of walls and inactive ones are left
/// out.
template <class T, int D>
struct FreeSurfaceGhosts {
  GhostSums<T, D> lists;        ///< of the ghosts 0..count-1; its sums are not kept
  const T* constrained_sum;     ///< [ghost] of b
  const T* surface_sum;         ///< [ghost] of a
  const std::int32_t* slot;     ///< [ghost]
  const std::int8_t* wall;      ///< [ghost] -1: none
  const std::uint8_t* active;   ///< [ghost]
  const std::int8_t* pressure;  ///< [ghost] place in `pressures`; -1: none
  const double* pressures;      ///< [Pa]
  T pressure_impedance;         ///< rho c_p
  T shear_impedance;            ///< rho c_s
  std::array<T*, D> velocity;   ///< [slot]
  std::array<T*, symmetric_components<D>> stress;
};

/// Pivots of a fit's normal matrix, relative to its largest, below which it counts as singular.
inline constexpr double smallest_pivot = 2e-3;

/// Terms of the fits (RP.32) and (RP.33) of a pack of ghosts, one in each lane. Entry k of
/// lane l, of its k-th particle, is [k * slots_per_pack + l]; lanes with fewer particles are filled
/// up with such as are farther than R away. All lengths are over h.
template <class T, int D>
struct SurfaceFits {
  int length;                        ///< of the longest list
  T radius;                          ///< R
  std::array<const T*, D> position;  ///< [entry] of particles, from the foot point
  const T* distance;                 ///< [entry] from the surface
  std::array<const T*, D> ghost;     ///< [lane] from the foot point
  std::array<const T*, D> normal;    ///< [lane] unit, out of the body
  const T* ghost_distance;           ///< [lane] from the surface
  const T* curved;                   ///< [lane] 1: with the term phi^2 of (RP.33); 0: without
  T* fitted;                         ///< [lane] 1, or 0 where the particles do not determine them
  T* constrained_sum;                ///< [lane] of the coefficients b
  std::array<T*, D + 1> linear, surface;  ///< [lane] see FitTerms
  std::array<T*, D + 2> constrained;      ///< [lane] likewise
};

template <class T, int D>
struct Table {
  Isa isa;
  int lanes;  ///< of a register
  StageResult (*advance_stage)(const Stage<T, D>&);
  StageResult (*evaluate_stress)(const StressOfState<T, D>&);
  void (*write_surface_records)(const SurfaceRecords<T, D>&);
  void (*sum_ghosts)(const GhostSums<T, D>&);
  void (*sum_velocities)(const GhostSums<T, D>&);  ///< sums[g][0] of u alone
  void (*fill_free_surfaces)(const FreeSurfaceGhosts<T, D>&);
  void (*scatter)(const Scatter<T, D>&);
  void (*filter)(const Filter<T, D>&);
  void (*find_closest_points)(const ClosestPoints<T, D>&);
  void (*fit_surface)(const SurfaceFits<T, D>&);
  StressPointsResult (*evaluate_stress_points)(const StressPoints<T, D>&);
  MotionResult (*advance_motion)(const Motion<T, D>&);
};

/// Kernels compiled for `isa`. Instantiated for <double, 2> and <double, 3>.
template <class T, int D>
const Table<T, D>& table(Isa isa);

}  // namespace pliant::kernels
