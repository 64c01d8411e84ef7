#pragma once

#include <array>
#include <cstdint>

#include "kernels/isa.hpp"
#include "kernels/layout.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshed/evolving.hpp"
#include "kernels/remeshed/ghosts/fit_terms.hpp"

/// What the kernels of ghosts work on: surface records, the fits of ghosts, and their sums.
namespace pliant::kernels {

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

/// Writes the records of one block's surface particles, grad phi by (RP.61).
template <class T, int D>
struct SurfaceRecords {
  const Segment<D>* segments;
  const SurfacePack* packs;
  int pack_count;
  T spacing;
  Material<T> material;
  const T* mass;
  const T* level_set;
  const T* interior;  ///< 1 for interior particles, else 0
  Evolving<const T, D> state;
  std::array<const T*, symmetric_components<D>> stress;
  T* records;                 ///< [record][record_width]
  bool renews_slopes = true;  ///< whether grad phi is found, not kept
  T lead = 0;            ///< how far ahead of the state grad phi is taken, with its velocity [s]
  bool relaxes = false;  ///< whether the stress holds the p_i of (RP.10) too
};

/// For ghosts first..first+count-1 and their neighbours i: sums[g][0][k] = sum_i c_gi record_i[k]
/// by (RP.43), sums[g][1][k] = sum_i b_gi record_i[k] by (RP.44), sums[g][2][k] = sum_i a_gi
/// record_i[k], the fit (RP.43) at the foot point.
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

/// Velocity and stress of ghosts by (RP.45), (RP.50), and the part of their velocity with which
/// they do not move, (RP.60); those of walls and inactive ones are left out.
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
  T* correction;  ///< [ghost][D] the part (RP.50) of the velocity
};

/// Pivots of a fit's normal matrix, relative to its largest, below which it counts as singular.
inline constexpr double smallest_pivot = 2e-3;

/// Terms of the fits (RP.43) and (RP.44) of a pack of ghosts, one in each lane. Entry k of
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
  const T* curved;                   ///< [lane] 1: with the term phi^2 of (RP.44); 0: without
  T* fitted;                         ///< [lane] 1, or 0 where the particles do not determine them
  T* constrained_sum;                ///< [lane] of the coefficients b
  std::array<T*, D + 1> linear, surface;  ///< [lane] see FitTerms
  std::array<T*, D + 2> constrained;      ///< [lane] likewise
};

template <class T, int D>
struct GhostKernels {
  void (*write_surface_records)(const SurfaceRecords<T, D>&);
  void (*sum_ghosts)(const GhostSums<T, D>&);
  /// sums[g][0] of u alone; of ghosts behind walls sums[g][1].
  void (*sum_velocities)(const GhostSums<T, D>&);
  void (*fill_free_surfaces)(const FreeSurfaceGhosts<T, D>&);
  void (*fit_surface)(const SurfaceFits<T, D>&);
};

/// Those compiled for `isa`.
template <Isa isa, class T, int D>
GhostKernels<T, D> ghost_kernels();

}  // namespace pliant::kernels
