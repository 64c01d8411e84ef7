#pragma once

#include <cstdint>

#include "kernels/pack.hpp"
#include "kernels/point_based/arguments.hpp"

namespace pliant::kernels {

/// Bonds of a register of nodes. The neighbours of bond k begin at k * slots_per_pack, its
/// coefficients at k * (D + 1) * slots_per_pack.
template <class T, int D>
struct RegisterBonds {
  const std::uint16_t* neighbour;
  const T* coefficient;

  const std::uint16_t* neighbours(int k) const { return neighbour + k * slots_per_pack; }
  /// g_ij for c < D, w_ij for c = D.
  const T* coefficients(int k, int c) const {
    return coefficient + (k * (D + 1) + c) * slots_per_pack;
  }
};

/// Prefetches bonds that a later register will read into the second cache. In large bodies, bonds
/// come from memory, and no bond is read again before the next step. A register of nodes prefetches
/// as many bytes as it reads, two packs ahead, half of them in each of its two loops: all of them
/// at once would wait for each other.
template <class P, int D>
class BondPrefetch {
  using T = Scalar<P>;
  static constexpr int packs_ahead = 2;
  static constexpr int line = 64;                                // [B]
  static constexpr int values_of_half = (D + 1) * lanes<P> / 2;  // for a bond, in each lane

 public:
  /// For a register of nodes, with the first lane `lane` of its pack and `count` bonds. `half` is 0
  /// in the first loop, which also prefetches neighbours, and 1 in the second.
  [[gnu::always_inline]] BondPrefetch(const RegisterBonds<T, D>& bonds, int count,
                                      std::int64_t lane, int half)
      : coefficient_(bonds.coefficient - lane +
                     ((packs_ahead * slots_per_pack + lane) * (D + 1) + half * values_of_half) *
                         count) {
    if (half > 0) return;
    const std::uint16_t* const neighbour =
        bonds.neighbour - lane + (packs_ahead * slots_per_pack + lane) * count;
    constexpr int numbers_of_line = line / sizeof(std::uint16_t);
    for (int i = 0; i < lanes<P> * count; i += numbers_of_line) ask(neighbour + i);
  }

  /// Called in the pass of a loop for bond k.
  [[gnu::always_inline]] void operator()(int k) const { ask(coefficient_ + k * values_of_half); }

 private:
  [[gnu::always_inline]] static void ask(const void* address) {
    constexpr int for_reading = 0, into_second_cache = 2;
    __builtin_prefetch(address, for_reading, into_second_cache);
  }

  const T* coefficient_;
};

}  // namespace pliant::kernels
