#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/point_based/cut_faces/body_simplices.hpp"
#include "engine/point_based/cut_faces/side_fit.hpp"

namespace pliant::point_based {

/// The parts of the volumes of nodes beyond a cut, (PB.37): cuts may pass anywhere between nodes.
///
/// They depend on the cuts alone, and are computed on the first query after a cut has grown.
template <int D>
class CutCells {
 public:
  /// `spacing` [m] is that of the lattice of the surface; unused if the body is a mesh.
  template <class T>
  CutCells(const Body<T, D>& body, double spacing);

  /// Updates the parts for cuts that have grown.
  void follow(std::span<const CutSurface<D>> cuts);

  /// A volume [m^D] whose nearest node `of` lies on the other side of a cut; `side` is the nearest
  /// node on its own side. Both are slots.
  struct Beyond {
    std::int32_t of, side;
    double volume;
  };
  std::span<const Beyond> beyond() const { return beyond_; }

 private:
  double spacing_;
  BodySimplices<D> simplices_;
  NodePlaces<D> nodes_;
  std::size_t pieces_ = 0;  ///< pieces of cuts considered so far
  std::vector<Beyond> beyond_;
};

extern template class CutCells<2>;
extern template class CutCells<3>;

}  // namespace pliant::point_based
