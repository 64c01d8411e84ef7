#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"

namespace pliant {

/// A particle as a search in space sees it. In periodic directions both its place and its cell are
/// moved by the same whole periods, until the place lies in the first one.
template <int D>
struct Site {
  Point<D> position;  ///< over h: the cell plus the drift from it
  Cell<D> cell;       ///< of the particle's slot
  std::int32_t slot;
};

/// Particles sorted by place into cubes, so that those within a radius of a point are found among
/// those of a few cubes.
///
///     . . . . . .      cubes are at least a radius wide: a point's neighbours lie in its own and
///     . x x x . .      in the adjacent ones (x); in periodic directions a whole number of cubes
///     . x o x . .      makes a period, and the row of cubes is a ring. A ring that is shorter than
///     . x x x . .      the radius is gone round more than once.
///
/// Takes time and memory linear in the number of particles.
template <int D>
class CellList {
 public:
  /// Lays cubes over the box from `lower` to `upper`, in periodic directions over the period, for
  /// searches within `radius`. All lengths are over h. No more cubes than `sites`, however far a
  /// few particles may have strayed.
  void cover(const Point<D>& lower, const Point<D>& upper, const Cell<D>& period, double radius,
             std::size_t sites);

  /// Sorts the sites that `for_each_site(f)` passes to f; it is called twice. Sites of one cube
  /// keep their order.
  template <class ForEachSite>
  void sort(std::size_t count, const ForEachSite& for_each_site) {
    begin_.assign(cubes() + 2, 0);
    for_each_site([&](const Site<D>& site) { ++begin_[cube_of(site.position) + 2]; });
    for (std::size_t c = 2; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    sites_.resize(count);
    for_each_site(
        [&](const Site<D>& site) { sites_[begin_[cube_of(site.position) + 1]++] = site; });
  }

  /// Calls f(site, shift) for every site that may lie within the radius of `at`, and perhaps
  /// others, until one call returns true; tells whether one did. The site's image is `shift` cells
  /// away from it, a whole number of periods.
  template <class F>
  bool any_near(const Point<D>& at, F&& f) const {
    Cell<D> first, last, cube;
    for (int a = 0; a < D; ++a) {
      first[a] = index(a, at[a]) - reach_[a];
      last[a] = index(a, at[a]) + reach_[a];
      if (period_[a] != 0) continue;
      first[a] = std::max(first[a], 0);
      last[a] = std::min(last[a], count_[a] - 1);
    }
    cube = first;
    while (true) {
      if (any_in(cube, f)) return true;
      int a = 0;
      while (a < D && ++cube[a] > last[a]) {
        cube[a] = first[a];
        ++a;
      }
      if (a == D) return false;
    }
  }

  std::size_t cubes() const;
  std::size_t bytes() const {
    return sites_.capacity() * sizeof(Site<D>) + begin_.capacity() * sizeof(begin_[0]);
  }

 private:
  std::int32_t index(int axis, double x) const;
  std::size_t cube_of(const Point<D>& position) const;

  template <class F>
  bool any_in(Cell<D> cube, F& f) const {
    Cell<D> shift = {};
    std::size_t at = 0;
    for (int a = D - 1; a >= 0; --a) {
      // The first period is the usual one: nothing to divide.
      while (cube[a] < 0) cube[a] += count_[a], shift[a] -= period_[a];
      while (cube[a] >= count_[a]) cube[a] -= count_[a], shift[a] += period_[a];
      at = at * count_[a] + cube[a];
    }
    for (std::int64_t s = begin_[at]; s < begin_[at + 1]; ++s) {
      if (f(sites_[s], shift)) return true;
    }
    return false;
  }

  Point<D> lower_ = {}, per_size_ = {};
  Cell<D> count_ = {}, period_ = {}, reach_ = {};
  std::vector<std::int64_t> begin_;  ///< [cube + 1] into sites_
  std::vector<Site<D>> sites_;
};

extern template class CellList<2>;
extern template class CellList<3>;

}  // namespace pliant
