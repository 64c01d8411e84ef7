#include "engine/remeshed/ghosts/initial_faces.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant::remeshed {

template <int D>
std::int8_t load_at(const Boundaries<D>& boundaries, const Point<D>& start) {
  for (std::size_t i = 0; i < boundaries.pressures.size(); ++i) {
    if (boundaries.pressures[i].acts_at(start)) return static_cast<std::int8_t>(i);
  }
  return no_load;
}

// A region may end in the plane of a loaded face, so the point just outside the face decides.
template <int D>
InitialFace<D> face_at(const Boundaries<D>& boundaries, const Shape& surface,
                       const Point<D>& start) {
  constexpr double just_outside = 1e-9;  // of coordinates
  const Vector near = padded<D>(start), n = outward_direction(surface, near, D);
  const double distance = signed_distance(surface, near, D);
  InitialFace<D> face{start, {}, no_load};
  double size = 0;
  for (const double component : start) size = std::max(size, std::abs(component));
  for (int a = 0; a < D; ++a) {
    face.normal[a] = n[a];
    face.place[a] += (just_outside * size - distance) * n[a];
  }
  face.load = load_at<D>(boundaries, face.place);
  return face;
}

template <class T, int D>
Point<D> present_normal(const Lattice<D>& lattice, const Layout<D>& layout,
                        const FieldStore<T, D>& fields, const Cell<D>& cell,
                        const Point<D>& initial) {
  Point<D> normal = initial;
  for_each_pair_beside<D>(lattice, layout, cell, [&](int a, std::int64_t q, std::int64_t r) {
    for (int i = 0; i < D; ++i) {
      const T* displacement = fields.get(Field::displacement, i);
      normal[a] -= (displacement[q] - displacement[r]) / (2 * lattice.spacing) * initial[i];
    }
  });
  const double length = norm<D>(normal);
  for (double& component : normal) component /= length;
  return normal;
}

template InitialFace<2> face_at<2>(const Boundaries<2>&, const Shape&, const Point<2>&);
template InitialFace<3> face_at<3>(const Boundaries<3>&, const Shape&, const Point<3>&);
template Point<2> present_normal<double, 2>(const Lattice<2>&, const Layout<2>&,
                                            const FieldStore<double, 2>&, const Cell<2>&,
                                            const Point<2>&);
template Point<3> present_normal<double, 3>(const Lattice<3>&, const Layout<3>&,
                                            const FieldStore<double, 3>&, const Cell<3>&,
                                            const Point<3>&);
template Point<2> present_normal<float, 2>(const Lattice<2>&, const Layout<2>&,
                                           const FieldStore<float, 2>&, const Cell<2>&,
                                           const Point<2>&);
template Point<3> present_normal<float, 3>(const Lattice<3>&, const Layout<3>&,
                                           const FieldStore<float, 3>&, const Cell<3>&,
                                           const Point<3>&);
template std::int8_t load_at<2>(const Boundaries<2>&, const Point<2>&);
template std::int8_t load_at<3>(const Boundaries<3>&, const Point<3>&);

}  // namespace pliant::remeshed
