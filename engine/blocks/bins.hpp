#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pliant {

/// Equal boxes that cover a region, at least one search radius wide.
///
///     . . . . . .      Everything within the radius of a point (o) is in its own bin or in the
///     . x x x . .      adjacent ones (x). In a periodic direction, a whole number of bins makes a
///     . x o x . .      period, and the row of bins is a ring. A ring that is shorter than the
///     . x x x . .      radius is passed more than once.
///
/// Bins do not depend on the cells of a lattice, only on positions and a radius.
template <int D>
class Bins {
 public:
  using Position = std::array<double, D>;

  /// Covers the box from `lower` to `upper`, and [0, period) in directions whose period is not 0,
  /// for searches within `radius`. All lengths have the same unit. There are at most `most` bins:
  /// they become wider if a few points are far from the others.
  void cover(const Position& lower, const Position& upper, const Position& period, double radius,
             std::size_t most);

  std::size_t count() const;

  /// The bin that contains a position, or else the nearest one; any bin for NaN.
  std::size_t bin_of(const Position& position) const {
    std::size_t bin = 0;
    for (int a = D - 1; a >= 0; --a) bin = bin * count_[a] + index(a, position[a]);
    return bin;
  }

  /// Calls f(bin, shift) for the bins that contain everything within the radius of `at`, until a
  /// call returns true. Returns whether one did. `shift` is a whole number of periods: the bin's
  /// image, moved by it, is near.
  template <class F>
  bool any_near(const Position& at, F&& f) const {
    Indices first, last, bin;
    for (int a = 0; a < D; ++a) {
      first[a] = index(a, at[a]) - reach_[a];
      last[a] = index(a, at[a]) + reach_[a];
      if (period_[a] != 0) continue;
      first[a] = std::max(first[a], 0);
      last[a] = std::min(last[a], count_[a] - 1);
    }
    bin = first;
    while (true) {
      if (visit(bin, f)) return true;
      int a = 0;
      while (a < D && ++bin[a] > last[a]) {
        bin[a] = first[a];
        ++a;
      }
      if (a == D) return false;
    }
  }

 private:
  using Indices = std::array<std::int32_t, D>;

  // Values that are not finite go to the first or the last bin.
  std::int32_t index(int axis, double x) const {
    const double bins = (x - lower_[axis]) * per_size_[axis];
    if (!(bins > 0)) return 0;
    return static_cast<std::int32_t>(std::min(bins, count_[axis] - 1.0));
  }

  template <class F>
  bool visit(Indices bin, F& f) const {
    Position shift = {};
    std::size_t number = 0;
    for (int a = D - 1; a >= 0; --a) {
      // Most bins are in the first period, where no division is needed.
      std::int32_t turns = 0;
      while (bin[a] < 0) bin[a] += count_[a], --turns;
      while (bin[a] >= count_[a]) bin[a] -= count_[a], ++turns;
      if (turns != 0) shift[a] = turns * period_[a];
      number = number * count_[a] + bin[a];
    }
    return f(number, shift);
  }

  Position lower_ = {}, per_size_ = {}, period_ = {};
  Indices count_ = {}, reach_ = {};
};

extern template class Bins<2>;
extern template class Bins<3>;

}  // namespace pliant
