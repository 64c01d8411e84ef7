#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/point_based/surface/surface_lattice.hpp"

namespace pliant::point_based {

/// Triangles (2D) or tetrahedra (3D) that fill an undeformed body: a conforming mesh.
template <int D>
struct Simplices {
  std::vector<Point<D>> places;  ///< [vertex] [m]; the first are the corners of the surface
  /// [simplex] vertices; the determinant of the edges from the first one is positive
  std::vector<std::array<std::int32_t, D + 1>> simplices;
};

/// Finds the simplices of a body: the elements of its mesh, else those of the lattice that its
/// surface comes from. A facet of only one simplex is a facet of the surface.
template <int D>
class BodySimplices {
 public:
  /// `spacing` [m] is that of the lattice.
  template <class T>
  BodySimplices(const Body<T, D>& body, double spacing);

  /// All simplices that touch one of the boxes; possibly more.
  Simplices<D> near(const std::vector<Box<D>>& boxes) const;

 private:
  using Corner = typename SurfaceLattice<D>::Corner;
  using Simplex = typename SurfaceLattice<D>::Simplex;

  std::vector<Simplex> elements_near(const std::vector<Box<D>>& boxes) const;

  std::optional<SurfaceLattice<D>> lattice_;
  std::vector<Simplex> elements_;  ///< used without a lattice
  std::vector<Point<D>> corners_;
  std::map<typename SurfaceLattice<D>::Name, std::int32_t> corner_of_;
};

extern template class BodySimplices<2>;
extern template class BodySimplices<3>;

}  // namespace pliant::point_based
