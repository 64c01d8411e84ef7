#pragma once

#include <functional>
#include <span>

#include "engine/blocks/box.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// The share 1 - S(d/(0.8 H)) of (CU.1) at `distance` d [m] from the front of a cut, for nodes of
/// size H [m].
double share_before_front(double distance, double size);

/// The distance at which this share becomes 0 [H].
inline constexpr double reach_of_front = 0.8;

/// Whether a place of the undeformed body is inside it, and not on its surface.
template <int D>
using InsideTest = std::function<bool(const MaterialPoint<D>&)>;

/// The front of a cut: the part of its boundary inside the body, from which it can grow. The
/// boundary on or outside the body's surface is not part of it, nor is a boundary that ends on
/// another cut or on another part of the same one, (PB.36).
template <int D>
class CutFront {
 public:
  /// The front is divided into parts no longer than `length` [m], each inside the body or not. A
  /// part within `length`/4 of another cut has joined it. A part has joined its own cut if pieces
  /// other than its own one are within `length`/2.
  CutFront(InsideTest<D> is_inside, double length)
      : is_inside_(std::move(is_inside)), length_(length) {}

  /// Updates the front after `cuts[which]` has grown or other cuts have reached it.
  void update(std::span<const CutSurface<D>> cuts, std::size_t which);

  /// Distance [m] from `x` to the front; `most` if it is larger or if there is no front left.
  double distance(const MaterialPoint<D>& x, double most) const;

  /// Box of all parts that were added or removed since forget_changes.
  const Box<D>& changed() const { return changed_; }
  void forget_changes() { changed_ = {}; }

 private:
  struct Part {
    MaterialPoint<D> from, to, middle;
    MaterialPoint<D> outward;  ///< in the cut, normal to the part: unit vector, or 0
  };
  using Cuts = std::span<const CutSurface<D>>;
  using Edge = typename CutSurface<D>::Edge;

  /// Adds the parts of an edge that are inside the body. `from` is the opposite edge of the piece
  /// that the edge bounds.
  void add_parts(const CutSurface<D>& cut, const Edge& edge, const Edge& from,
                 std::vector<Part>& parts) const;
  /// The parts of a station's edge at which the blade has turned back along its path.
  std::vector<Part> turned_back(const CutSurface<D>& cut, std::int32_t station) const;
  /// Removes the parts that have joined a cut; only its pieces from `from`[cut] on are tested.
  void remove_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                     std::vector<Part>& parts);
  bool has_joined(Cuts cuts, std::size_t which, std::span<const std::size_t> from,
                  const Part& part) const;
  bool meets_own(const Part& part, const std::array<MaterialPoint<D>, D>& piece) const;
  void add_to_changed(const std::vector<Part>& parts);

  InsideTest<D> is_inside_;
  double length_;
  std::vector<Part> rim_, leading_;  ///< rims stay, leading edges move
  std::int32_t stations_ = 0;        ///< stations that the front has followed
  std::vector<std::size_t> tested_;  ///< [cut] pieces that rims were compared with
  Box<D> changed_;
};

extern template class CutFront<2>;
extern template class CutFront<3>;

}  // namespace pliant::point_based
