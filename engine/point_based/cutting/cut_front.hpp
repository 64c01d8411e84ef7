#pragma once

#include <functional>
#include <span>

#include "engine/blocks/box.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// The share 1 - S(d/(0.8 H)) of (CU.1) at `distance` d from the front of a cut [m] among nodes of
/// the size H [m].
double share_before_front(double distance, double size);

/// The distance from which on that share is 0 [H].
inline constexpr double reach_of_front = 0.8;

/// Whether a place of the undeformed body is inside it, and not on its surface.
template <int D>
using InsideTest = std::function<bool(const MaterialPoint<D>&)>;

/// The front of a cut: the part of its boundary inside the body, from where it can grow. The
/// boundary on or outside the body's surface does not count, nor what ends on another cut or on
/// another part of the same one, (PB.36).
template <int D>
class CutFront {
 public:
  /// The front is divided into parts no longer than `length` [m], each of which is inside the body
  /// or not. What comes within `length`/4 of another cut has joined it; what has more of its own
  /// cut at `length`/2 than the piece that it bounds has joined that.
  CutFront(InsideTest<D> is_inside, double length)
      : is_inside_(std::move(is_inside)), length_(length) {}

  /// Follows `cuts[which]`, which may have grown, and others that may have reached it.
  void update(std::span<const CutSurface<D>> cuts, std::size_t which);

  /// Distance [m] from `x` to the front; `most` where it is farther away, or where there is none
  /// any more.
  double distance(const MaterialPoint<D>& x, double most) const;

  /// Holds all parts of the front that have come or gone since forget_changes.
  const Box<D>& changed() const { return changed_; }
  void forget_changes() { changed_ = {}; }

 private:
  struct Part {
    MaterialPoint<D> from, to, middle;
    MaterialPoint<D> outward;  ///< in the cut, normal to the part: unit vector, or 0
  };
  using Cuts = std::span<const CutSurface<D>>;
  using Edge = typename CutSurface<D>::Edge;

  /// Adds the parts of an edge that are inside the body; `from` is an edge of the cut on the other
  /// side of the piece that it bounds.
  void add_parts(const CutSurface<D>& cut, const Edge& edge, const Edge& from,
                 std::vector<Part>& parts) const;
  /// The parts of the edge of a station from which the blade has gone back the way it came.
  std::vector<Part> turned_back(const CutSurface<D>& cut, std::int32_t station) const;
  /// Takes away the parts that have come to a cut, with its pieces from `from`[cut] on.
  void remove_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                     std::vector<Part>& parts);
  bool has_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                  const Part& part) const;
  bool meets_own(const Part& part, const std::array<MaterialPoint<D>, D>& piece) const;
  void add_to_changed(const std::vector<Part>& parts);

  InsideTest<D> is_inside_;
  double length_;
  std::vector<Part> rim_, leading_;  ///< rims stay, leading edges move on
  std::int32_t stations_ = 0;        ///< that the front has followed
  std::vector<std::size_t> tested_;  ///< [cut] pieces that rims have been compared with
  Box<D> changed_;
};

extern template class CutFront<2>;
extern template class CutFront<3>;

}  // namespace pliant::point_based
