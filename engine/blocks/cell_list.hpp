#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/blocks/bins.hpp"

namespace pliant {

/// A point of a cell list, with a label of its owner: one or several numbers.
template <class T, int D, class Label = std::int32_t>
struct Site {
  std::array<T, D> position;
  Label label;
};

/// Points sorted by position into bins, so that those within a radius of a position are in a few
/// bins. Takes time and memory linear in the number of points.
///
/// T is the type of the coordinates (float or double), Label the data of each point.
template <class T, int D, class Label = std::int32_t>
class CellList {
 public:
  using Position = std::array<T, D>;
  using Site = pliant::Site<T, D, Label>;

  /// Prepares for `count` points in the box from `lower` to `upper` and for searches within
  /// `radius`. A direction whose `period` is not 0 is periodic, with its points in [0, period). All
  /// lengths have the same unit.
  void cover(const Position& lower, const Position& upper, const Position& period, T radius,
             std::size_t count) {
    bins_.cover(exact(lower), exact(upper), exact(period), radius, count);
  }

  /// Sorts the `count` sites that `for_each_site(f)` passes to f; it is called twice. Sites in the
  /// same bin keep their order.
  template <class ForEachSite>
  void sort(std::size_t count, const ForEachSite& for_each_site) {
    begin_.assign(bins_.count() + 2, 0);
    for_each_site([&](const Site& site) { ++begin_[bins_.bin_of(exact(site.position)) + 2]; });
    for (std::size_t b = 2; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    sites_.resize(count);
    for_each_site(
        [&](const Site& site) { sites_[begin_[bins_.bin_of(exact(site.position)) + 1]++] = site; });
  }

  /// Calls f(site, shift) for every site that may be within the radius of `at`, and possibly
  /// others, until a call returns true. Returns whether one did. The position of the image nearby
  /// is that of the site plus `shift`, a whole number of periods.
  template <class F>
  bool any_near(const Position& at, F&& f) const {
    return bins_.any_near(exact(at), [&](std::size_t bin, const std::array<double, D>& moved) {
      const Position shift = converted<T>(moved);
      for (std::int64_t s = begin_[bin]; s < begin_[bin + 1]; ++s) {
        if (f(sites_[s], shift)) return true;
      }
      return false;
    });
  }

  std::size_t bins() const { return bins_.count(); }
  std::size_t bytes() const {
    return sites_.capacity() * sizeof(Site) + begin_.capacity() * sizeof(begin_[0]);
  }

 private:
  template <class To, class From>
  static std::array<To, D> converted(const std::array<From, D>& x) {
    if constexpr (std::is_same_v<To, From>) {
      return x;
    } else {
      std::array<To, D> result;
      for (int a = 0; a < D; ++a) result[a] = static_cast<To>(x[a]);
      return result;
    }
  }
  static std::array<double, D> exact(const Position& x) { return converted<double>(x); }

  Bins<D> bins_;
  std::vector<std::int64_t> begin_;  ///< [bin + 1] into sites_
  std::vector<Site> sites_;
};

}  // namespace pliant
