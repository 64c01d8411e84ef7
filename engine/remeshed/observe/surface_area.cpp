#include "engine/remeshed/observe/surface_area.hpp"

#include <Eigen/Geometry>

#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

namespace {

double size_of(const std::array<PlaceVector<2>, 2>& segment) {
  return (segment[1] - segment[0]).norm();
}

double size_of(const std::array<PlaceVector<3>, 3>& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm() / 2;
}

}  // namespace

template <class T, int D>
double surface_area(const LatticeView<T, D>& view, const Boundaries<D>& boundaries) {
  double sum = 0;
  for_each_surface_piece(view, boundaries,
                         [&](const SurfacePiece<D>&, const std::array<PlaceVector<D>, D>& places) {
                           sum += size_of(places);
                         });
  return sum;
}

template double surface_area<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&);
template double surface_area<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&);
template double surface_area<float, 2>(const LatticeView<float, 2>&, const Boundaries<2>&);
template double surface_area<float, 3>(const LatticeView<float, 3>&, const Boundaries<3>&);

}  // namespace pliant::remeshed
