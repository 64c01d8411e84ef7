#pragma once

#include <functional>
#include <map>
#include <span>

#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// Whether a place of the undeformed body is inside it, and not on its surface.
template <int D>
using InsideTest = std::function<bool(const MaterialPoint<D>&)>;

/// The front of a cut: the part of its boundary inside the body, from where it can grow. The
/// boundary on or outside the body's surface does not count, nor what ends on another cut.
template <int D>
class CutFront {
 public:
  /// The front is divided into parts no longer than `length` [m], each of which is inside the body
  /// or not. What comes within `length`/4 of another cut has joined it.
  CutFront(InsideTest<D> is_inside, double length)
      : is_inside_(std::move(is_inside)), length_(length) {}

  /// Finds the front of `cuts[which]` anew.
  void update(std::span<const CutSurface<D>> cuts, std::size_t which);

  /// Distance [m] from `x` to the front; `most` where it is farther away, or where there is none
  /// any more.
  double distance(const MaterialPoint<D>& x, double most) const;

 private:
  struct Part {
    MaterialPoint<D> from, to, middle;
  };

  const std::vector<Part>& parts_inside(const CutSurface<D>& cut,
                                        const std::array<std::int32_t, 2>& edge);
  bool has_joined(std::span<const CutSurface<D>> cuts, std::size_t which, const Part& part) const;

  InsideTest<D> is_inside_;
  double length_;
  std::map<std::array<std::int32_t, 2>, std::vector<Part>> inside_;  ///< by edge; edges never move
  std::vector<Part> front_;
};

extern template class CutFront<2>;
extern template class CutFront<3>;

}  // namespace pliant::point_based
