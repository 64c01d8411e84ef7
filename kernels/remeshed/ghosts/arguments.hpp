#pragma once

#include <array>
#include <cstdint>

#include "kernels/isa.hpp"
#include "kernels/layout.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshed/evolving.hpp"
#include "kernels/remeshed/ghosts/fit_terms.hpp"

/// Arguments of the kernels of ghosts: surface records, the fits of ghosts, and their sums.
namespace pliant::kernels {

/// Positions of the fields in the record of a surface particle. Fields that all fits of a
/// free-surface ghost need come first. Zeros pad u to whole registers of four doubles, and the
/// record to cache lines of eight.
template <int D>
struct RecordPlace {
  static constexpr int stress = 0;                             ///< sigma
  static constexpr int pressure = symmetric_components<D>;     ///< p
  static constexpr int velocity = (pressure + 1 + 3) / 4 * 4;  ///< u (D)
  static constexpr int slope = velocity + D;                   ///< grad phi (D)
};
template <int D>
inline constexpr int record_width = (RecordPlace<D>::slope + D + 7) / 8 * 8;

/// A pack of slots that has surface particles.
struct SurfacePack {
  std::int64_t first;    ///< slot
  std::int32_t segment;  ///< of the block
  std::int32_t record;   ///< record of its first surface particle; the others follow by lane
  std::uint16_t lanes;   ///< bit l: lane l is a surface particle
};

/// Writes the records of the surface particles of a block, with grad phi by (RP.61).
template <class T, int D>
struct SurfaceRecords {
  const Segment<D>* segments;
  const SurfacePack* packs;
  int pack_count;
  T spacing;
  Material<T> material;
  const T* mass;
  const T* level_set;
  const Mark* interior;  ///< 1 for interior particles, else 0
  Evolving<const T, D> state;
  std::array<const T*, symmetric_components<D>> stress;
  T* records;                 ///< [record][record_width]
  bool renews_slopes = true;  ///< whether to compute grad phi, or keep it
  T lead = 0;            ///< grad phi is taken at this time after the state, by its velocity [s]
  bool relaxes = false;  ///< whether the stress includes the p_i of (RP.10)
};

/// For ghosts first..first+count-1 and their neighbours i: sums[g][0][k] = sum_i c_gi record_i[k]
/// by (RP.43), sums[g][1][k] = sum_i b_gi record_i[k] by (RP.44), sums[g][2][k] = sum_i a_gi
/// record_i[k], where a is the fit (RP.43) at the foot point.
template <class T, int D>
struct GhostSums {
  std::int64_t first;
  std::int64_t count;
  const std::int64_t* begin;       ///< [ghost + 1] into pairs
  const FitPair* pairs;            ///< of neighbours; whole registers of them are loaded
  const FitTerms<T, D>* terms;     ///< [ghost]
  const std::int64_t* wall_begin;  ///< [ghost] into wall_distance; -1 at free surfaces
  const T* wall_distance;          ///< of the neighbours, over h; loaded like the pairs
  const T* surface_distance;       ///< [record] over h
  const T* records;                ///< [record][record_width]
  T* sums;                         ///< [ghost - first][3][record_width]
};

/// Velocity and stress of free-surface ghosts by (RP.45), (RP.50), and the part of their velocity
/// that does not move them, (RP.60). Ghosts of walls and inactive ones are skipped.
template <class T, int D>
struct FreeSurfaceGhosts {
  GhostSums<T, D> lists;        ///< of the ghosts 0..count-1; its sums are temporary
  const T* constrained_sum;     ///< [ghost] sum of b
  const T* surface_sum;         ///< [ghost] sum of a
  const std::int32_t* slot;     ///< [ghost]
  const std::int8_t* wall;      ///< [ghost] -1: none
  const std::uint8_t* active;   ///< [ghost]
  const std::int8_t* pressure;  ///< [ghost] index in `pressures`; -1: none
  const double* pressures;      ///< [Pa]
  T pressure_impedance;         ///< rho c_p
  T shear_impedance;            ///< rho c_s
  std::array<T*, D> velocity;   ///< [slot]
  std::array<T*, symmetric_components<D>> stress;
  T* correction;  ///< [ghost][D] the part (RP.50) of the velocity
};

/// A fit's normal matrix is singular if its smallest pivot is below this share of the largest.
inline constexpr double smallest_pivot = 2e-3;

/// Computes the terms of the fits (RP.43) and (RP.44) of a pack of ghosts, one in each lane. Entry
/// k of lane l, its k-th particle, is [k * slots_per_pack + l]. Lanes with fewer particles are
/// padded with particles farther away than R. All lengths are over h.
template <class T, int D>
struct SurfaceFits {
  int length;                        ///< of the longest list
  T radius;                          ///< R
  std::array<const T*, D> position;  ///< [entry] of particles, relative to the foot point
  const T* distance;                 ///< [entry] from the surface
  std::array<const T*, D> ghost;     ///< [lane] relative to the foot point
  std::array<const T*, D> normal;    ///< [lane] unit vector, out of the body
  const T* ghost_distance;           ///< [lane] from the surface
  const T* curved;                   ///< [lane] share of the fit (RP.44) with the term phi^2
  T* fitted;           ///< [lane] 1, or 0 where the particles do not determine the fits
  T* constrained_sum;  ///< [lane] sum of the coefficients b
  std::array<T*, D + 1> linear, surface;  ///< [lane] see FitTerms
  std::array<T*, D + 2> constrained;      ///< [lane] likewise
};

template <class T, int D>
struct GhostKernels {
  void (*write_surface_records)(const SurfaceRecords<T, D>&);
  void (*sum_ghosts)(const GhostSums<T, D>&);
  /// Computes sums[g][0] of u only; for ghosts behind walls, sums[g][1].
  void (*sum_velocities)(const GhostSums<T, D>&);
  void (*fill_free_surfaces)(const FreeSurfaceGhosts<T, D>&);
  void (*fit_surface)(const SurfaceFits<T, D>&);
};

template <Isa isa, class T, int D>
GhostKernels<T, D> ghost_kernels();

}  // namespace pliant::kernels
