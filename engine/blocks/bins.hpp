#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pliant {

/// Equal boxes over a region of space, at least a search radius wide.
///
///     . . . . . .      What lies within the radius of a point (o) lies in its own bin and in the
///     . x x x . .      adjacent ones (x). In a periodic direction a whole number of bins makes a
///     . x o x . .      period, and the row of bins is a ring. A ring that is shorter than the
///     . x x x . .      radius is passed more than once.
///
/// Bins have nothing to do with the cells of a lattice: they know positions and a radius.
template <int D>
class Bins {
 public:
  using Position = std::array<double, D>;

  /// Lays bins over the box from `lower` to `upper`, and over [0, period) in directions whose
  /// period is not 0, for searches within `radius`. All are lengths of one unit. There are at most
  /// `most` bins: they become wider where a few points lie far from the others.
  void cover(const Position& lower, const Position& upper, const Position& period, double radius,
             std::size_t most);

  std::size_t count() const;

  /// The bin that holds a position; the nearest one where none does, any one for NaN.
  std::size_t bin_of(const Position& position) const {
    std::size_t bin = 0;
    for (int a = D - 1; a >= 0; --a) bin = bin * count_[a] + index(a, position[a]);
    return bin;
  }

  /// Calls f(bin, shift) for the bins that hold everything within the radius of `at`, until one
  /// call returns true; tells whether one did. `shift` is a whole number of periods: what is seen
  /// is the image of the bin moved by it.
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

  // What is not finite goes to the first or the last bin.
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
      // Most bins lie in the first period: nothing to divide.
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
