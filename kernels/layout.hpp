#pragma once

#include <array>
#include <cstdint>

/// How kernels see particles: as slots of a lattice, stored in rows.
///
///     row y+1   . . . o o o o o o . .      a segment is a run of slots of one lattice row whose
///     row y     . . o o o[o o o o]o . .    neighbouring rows are each one constant offset away:
///     row y-1   . . . o o o o o o o .      slot(x + dx, row + r) = p + neighbour_row[r] + dx
///
/// Storage consists of packs of `slots_per_pack` slots (one cache line of doubles, half a line of
/// floats) for any instruction set and precision, so that the layout does not depend on them. Every
/// interior particle has slots on all sides, and every slot has finite values, so all loads of a
/// pack with an interior particle are legal.
namespace pliant::kernels {

/// Segments start at multiples of this number of slots and have a multiple of it.
inline constexpr int slots_per_pack = 8;

/// Neighbouring rows and columns on each side for which a segment has offsets.
inline constexpr int row_reach = 3;

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// Rows around a row, including itself: 7 in 2D (dy = -3..3), 49 in 3D (dy fastest, then dz).
template <int D>
inline constexpr int neighbouring_rows = power(2 * row_reach + 1, D - 1);

/// Position in `Segment::neighbour_row` of the row (dy) or (dy, dz).
template <int D>
constexpr int row_index(int dy, int dz = 0) {
  return D == 2 ? dy + row_reach : (dz + row_reach) * (2 * row_reach + 1) + dy + row_reach;
}

/// Independent components of a symmetric tensor: xx, xy, yy in 2D; xx, xy, xz, yy, yz, zz in 3D.
template <int D>
inline constexpr int symmetric_components = D*(D + 1) / 2;

/// Position of component (i, j) of a symmetric tensor.
template <int D>
constexpr int symmetric_index(int i, int j) {
  if (i > j) return symmetric_index<D>(j, i);
  return i * D - i * (i - 1) / 2 + (j - i);
}

/// Components of the largest material state: S (symmetric) or F (row-major D x D).
template <int D>
inline constexpr int material_components = D* D;

template <int D>
struct Segment {
  std::int64_t first;                ///< slot, a multiple of slots_per_pack
  std::int32_t count;                ///< slots, a multiple of slots_per_pack
  std::array<std::int32_t, D> cell;  ///< lattice cell of the first slot
  std::array<std::int64_t, neighbouring_rows<D>> neighbour_row;  ///< slot offsets, by row_index
};

/// The content of a slot. Only interior particles follow the equations of motion.
enum class Kind : std::uint8_t {
  vacant = 0,
  interior = 1,
  free_ghost = 2,
  wall_ghost = 3,
  image = 4
};

/// Marks a slot that holds an interior particle by 1, others by 0. Kernels multiply by marks; they
/// are in single precision always, since they take memory in every slot.
using Mark = float;

/// The content of a pack: vacant; ghosts or images without interior particles; interior particles
/// in some slots, or in all.
enum class PackState : std::uint8_t { vacant = 0, ghosts = 1, some = 2, all = 3 };

constexpr bool holds_interior(PackState state) { return state >= PackState::some; }

}  // namespace pliant::kernels
