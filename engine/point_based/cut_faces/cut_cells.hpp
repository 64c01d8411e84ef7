#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/point_based/cut_faces/body_simplices.hpp"
#include "engine/point_based/cut_faces/side_fit.hpp"

namespace pliant::point_based {

/// What the nodes near cuts hold of the other side, (PB.37): cuts go between nodes anywhere, or
/// through them, and so through the volume that nodes stand for.
///
/// It follows from the cuts alone, and is found when it is first asked for after one has grown.
template <int D>
class CutCells {
 public:
  /// `spacing` is that of the lattice of the surface [m], where the body is no mesh.
  template <class T>
  CutCells(const Body<T, D>& body, double spacing);

  /// Follows cuts that have grown.
  void follow(std::span<const CutSurface<D>> cuts);

  /// A volume [m^D] nearest to one node, on whose other side of a cut it lies, and the nearest node
  /// on its own side: slots.
  struct Beyond {
    std::int32_t of, side;
    double volume;
  };
  std::span<const Beyond> beyond() const { return beyond_; }

 private:
  double spacing_;
  BodySimplices<D> simplices_;
  NodePlaces<D> nodes_;
  std::size_t pieces_ = 0;  ///< of cuts that it has followed
  std::vector<Beyond> beyond_;
};

extern template class CutCells<2>;
extern template class CutCells<3>;

}  // namespace pliant::point_based
