#pragma once

#include <array>
#include <cstdint>

#include "engine/boundaries/walls.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/state/body.hpp"

/// The surface at t = 0, and where its normals are now.
namespace pliant::remeshed {

/// A place of the surface at t = 0.
template <int D>
struct InitialFace {
  Point<D> place;   ///< just outside of the surface [m]
  Point<D> normal;  ///< unit, out of the body
  std::int8_t load;
};

/// The point of the plane of a face next to `x`.
template <int D>
Point<D> onto_plane(const InitialFace<D>& face, const Point<D>& x) {
  const double height = dot<D>(difference<D>(x, face.place), face.normal);
  Point<D> foot = x;
  for (int a = 0; a < D; ++a) foot[a] -= height * face.normal[a];
  return foot;
}

/// Whether places belong to one face, by the cosine between their normals.
inline constexpr double one_face = 0.8;

/// The load on the material that was at `start` at t = 0.
template <int D>
std::int8_t load_at(const Boundaries<D>& boundaries, const Point<D>& start);

/// The place on a surface nearest to `start`, its face, and the load there.
template <int D>
InitialFace<D> face_at(const Boundaries<D>& boundaries, const Shape& surface,
                       const Point<D>& start);

/// Calls f(a, q, r) for each axis a on which the cells above and below have the slots q and r.
template <int D, class F>
void for_each_pair_beside(const Lattice<D>& lattice, const Layout<D>& layout, const Cell<D>& cell,
                          F&& f) {
  for (int a = 0; a < D; ++a) {
    Cell<D> up = cell, down = cell;
    ++up[a];
    --down[a];
    const std::int64_t q = layout.slot(lattice.wrapped(up));
    const std::int64_t r = layout.slot(lattice.wrapped(down));
    if (q >= 0 && r >= 0) f(a, q, r);
  }
}

/// The present direction of the normal N of a face at t = 0, F^-T N with F^-1 = I - grad d from the
/// nodes beside that of a cell. Particles must be on nodes.
template <class T, int D>
Point<D> present_normal(const Lattice<D>& lattice, const Layout<D>& layout,
                        const FieldStore<T, D>& fields, const Cell<D>& cell,
                        const Point<D>& initial);

}  // namespace pliant::remeshed
