#include "engine/remeshed/ghosts/record_loads.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"

namespace pliant::remeshed {

namespace {

constexpr double known = 0.02;   // [h] accuracy of places at t = 0: regions may end on a face
constexpr double unseen = 1e-3;  // of the squares of grad phi; below it they have no direction

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

/// Finds the faces and loads near the particles of a block.
template <class T, int D>
class LoadFinder {
 public:
  LoadFinder(const Lattice<D>& lattice, const Layout<D>& layout, const FieldStore<T, D>& fields,
             const Shape& surface, const Boundaries<D>& boundaries)
      : surface_(surface),
        lattice_(lattice),
        layout_(layout),
        fields_(fields),
        boundaries_(boundaries) {}

  /// The load on the particle in `slot`, the normal of its face, and grad phi.
  std::int8_t find(std::int64_t slot, std::array<T, D>& face, std::array<T, D>& slope) const {
    const Cell<D> cell = layout_.cell(slot);
    const Point<D> moved = displacement(slot);
    Point<D> x = lattice_.node(cell);
    for (int a = 0; a < D; ++a) x[a] -= moved[a];
    const InitialFace<D> initial = nearest_face(x);
    const Point<D> normal = present_normal<T, D>(lattice_, layout_, fields_, cell, initial.normal);
    const Point<D> gradient = slope_at(cell, initial.normal);
    for (int a = 0; a < D; ++a) {
      face[a] = static_cast<T>(normal[a]);
      slope[a] = static_cast<T>(gradient[a]);
    }
    return initial.load;
  }

 private:
  // For a place on the bisector of an edge, rounding would decide which face is nearest: a loaded
  // face is preferred.
  InitialFace<D> nearest_face(const Point<D>& start) const {
    InitialFace<D> face = face_at<D>(boundaries_, surface_, start);
    for (int a = 0; a < D && face.load < 0; ++a) {
      for (const double way : {-known, known}) {
        Point<D> beside = start;
        beside[a] += way * lattice_.spacing;
        if (const auto other = face_at<D>(boundaries_, surface_, beside); other.load >= 0) {
          face = other;
        }
      }
    }
    return face;
  }

  // grad phi, or the initial normal where a node beside has no slot.
  Point<D> slope_at(const Cell<D>& cell, const Point<D>& initial) const {
    const T* phi = fields_.get(Field::level_set);
    Point<D> slope = initial;
    for_each_pair_beside<D>(lattice_, layout_, cell, [&](int a, std::int64_t q, std::int64_t r) {
      slope[a] = (phi[q] - phi[r]) / (2 * lattice_.spacing);
    });
    return slope;
  }

  Point<D> displacement(std::int64_t slot) const {
    Point<D> value;
    for (int a = 0; a < D; ++a) value[a] = fields_.get(Field::displacement, a)[slot];
    return value;
  }

  const Shape& surface_;
  const Lattice<D>& lattice_;
  const Layout<D>& layout_;
  const FieldStore<T, D>& fields_;
  const Boundaries<D>& boundaries_;
};

/// The load on the material that was at `start` at t = 0.
template <int D>
std::int8_t load_at(const Boundaries<D>& boundaries, const Point<D>& start) {
  for (std::size_t i = 0; i < boundaries.pressures.size(); ++i) {
    if (boundaries.pressures[i].acts_at(start)) return static_cast<std::int8_t>(i);
  }
  return no_load;
}

}  // namespace

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

// A region may end in the plane of a loaded face, so the point just outside the face decides.
template <int D>
InitialFace<D> face_at(const Boundaries<D>& boundaries, const Shape& surface,
                       const Point<D>& start) {
  constexpr double rounding = 1e-9;  // of coordinates
  const Vector near = padded<D>(start), n = outward_direction(surface, near, D);
  const double distance = signed_distance(surface, near, D);
  InitialFace<D> face{{}, no_load};
  Point<D> x = start;
  double size = 0;
  for (const double component : start) size = std::max(size, std::abs(component));
  for (int a = 0; a < D; ++a) {
    face.normal[a] = n[a];
    x[a] += (rounding * size - distance) * n[a];
  }
  face.load = load_at<D>(boundaries, x);
  return face;
}

template <class T, int D>
void find_record_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                       const Shape& surface, const Boundaries<D>& boundaries, int block,
                       Population<T, D>& population) {
  const LoadFinder<T, D> finder(lattice, population.layout, fields, surface, boundaries);
  const BlockGhosts<T, D>& ghosts = population.ghosts[block];
  for (std::int32_t r = ghosts.first_record; r < ghosts.first_record + ghosts.record_count; ++r) {
    population.load[r] =
        finder.find(population.slot_of_record[r], population.face[r], population.slope[r]);
  }
}

namespace {

// The load of the faces of all particles in its fit, if they agree.
template <class T, int D>
std::int8_t load_of_faces(const Population<T, D>& population, const BlockGhosts<T, D>& ghosts,
                          std::size_t g) {
  const auto load = [&](std::int64_t k) {
    return population.load[kernels::record_of(ghosts.pairs[k])];
  };
  const std::int64_t first = ghosts.begin[g];
  for (std::int64_t k = first; k < ghosts.begin[g + 1]; ++k) {
    if (load(k) != load(first)) return several_loads;
  }
  return first == ghosts.begin[g + 1] ? no_load : load(first);
}

}  // namespace

template <class T, int D>
void find_ghost_loads(Population<T, D>& population, int block) {
  BlockGhosts<T, D>& ghosts = population.ghosts[block];
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    if (ghosts.wall[g] >= 0) continue;
    ghosts.pressure[g] = load_of_faces(population, ghosts, g);
  }
}

namespace {

/// B of (RP.78): the rotation of normals near a ghost since the remeshing, from that of grad phi.
template <class T, int D>
Eigen::Matrix<T, D, D> turn_of_normals(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                       std::size_t ghost) {
  using Matrix = Eigen::Matrix<T, D, D>;
  using Vector = Eigen::Matrix<T, D, 1>;
  Matrix squares = Matrix::Zero(), changes = Matrix::Zero();
  for (std::int64_t k = ghosts.begin[ghost]; k < ghosts.begin[ghost + 1]; ++k) {
    const std::int64_t record = kernels::record_of(ghosts.pairs[k]);
    const kernels::RecordSum<T, D> particle{body.records.get() + record * kernels::record_width<D>};
    const T w = FittedParticle<T, D>(ghosts, ghost, k).weight();
    const Vector before = Eigen::Map<const Vector>(body.population.slope[record].data());
    Vector now;
    for (int a = 0; a < D; ++a) now[a] = particle.level_set_gradient(a);
    squares += w * before * before.transpose();
    changes += w * (now - before) * before.transpose();
  }
  // Directions without information do not rotate.
  squares.diagonal().array() += T(unseen) * squares.trace();
  return changes * squares.inverse();
}

}  // namespace

// The traction of the uniform stress that fits those of the faces along their normals.
template <class T, int D>
kernels::SurfaceLoad<T, D> mixed_load(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                      const kernels::GhostFits<T, D>& fits, std::size_t ghost,
                                      const BoundaryValues<D>& values) {
  using Vector = Eigen::Matrix<T, D, 1>;
  using Matrix = Eigen::Matrix<T, D, D>;
  const Matrix turn = turn_of_normals(body, ghosts, ghost);
  Matrix squares = Matrix::Zero(), products = Matrix::Zero();
  for (std::int64_t k = ghosts.begin[ghost]; k < ghosts.begin[ghost + 1]; ++k) {
    const std::int64_t record = kernels::record_of(ghosts.pairs[k]);
    const std::int8_t load = body.population.load[record];
    const T w = FittedParticle<T, D>(ghosts, ghost, k).weight();
    const Vector face = Eigen::Map<const Vector>(body.population.face[record].data());
    const Vector normal = face + turn * face;
    squares += w * normal * normal.transpose();
    if (load < 0) continue;
    const T length = normal.norm();
    Vector traction;
    for (int a = 0; a < D; ++a) traction[a] = static_cast<T>(values.traction[load][a]) * length;
    traction -= static_cast<T>(values.pressure[load]) * normal;
    products += w * traction.dot(normal) / normal.squaredNorm() * normal * normal.transpose();
  }
  squares.diagonal().array() += T(unseen) * squares.trace();
  const auto unit = kernels::unit_normal<T, D>(fits.linear);
  const Vector n = Eigen::Map<const Vector>(unit.data());
  const Vector load = products * squares.inverse() * n;
  kernels::SurfaceLoad<T, D> result = {};
  result.normal = load.dot(n);
  for (int a = 0; a < D; ++a) {
    result.n[a] = n[a];
    result.shear[a] = load[a] - result.normal * n[a];
  }
  return result;
}

template InitialFace<2> face_at<2>(const Boundaries<2>&, const Shape&, const Point<2>&);
template InitialFace<3> face_at<3>(const Boundaries<3>&, const Shape&, const Point<3>&);
template void find_record_loads<double, 2>(const Lattice<2>&, const FieldStore<double, 2>&,
                                           const Shape&, const Boundaries<2>&, int,
                                           Population<double, 2>&);
template Point<2> present_normal<double, 2>(const Lattice<2>&, const Layout<2>&,
                                            const FieldStore<double, 2>&, const Cell<2>&,
                                            const Point<2>&);
template void find_ghost_loads<double, 2>(Population<double, 2>&, int);
template kernels::SurfaceLoad<double, 2> mixed_load<double, 2>(const Body<double, 2>&,
                                                               const BlockGhosts<double, 2>&,
                                                               const kernels::GhostFits<double, 2>&,
                                                               std::size_t,
                                                               const BoundaryValues<2>&);
template void find_record_loads<double, 3>(const Lattice<3>&, const FieldStore<double, 3>&,
                                           const Shape&, const Boundaries<3>&, int,
                                           Population<double, 3>&);
template Point<3> present_normal<double, 3>(const Lattice<3>&, const Layout<3>&,
                                            const FieldStore<double, 3>&, const Cell<3>&,
                                            const Point<3>&);
template void find_ghost_loads<double, 3>(Population<double, 3>&, int);
template kernels::SurfaceLoad<double, 3> mixed_load<double, 3>(const Body<double, 3>&,
                                                               const BlockGhosts<double, 3>&,
                                                               const kernels::GhostFits<double, 3>&,
                                                               std::size_t,
                                                               const BoundaryValues<3>&);
template void find_record_loads<float, 2>(const Lattice<2>&, const FieldStore<float, 2>&,
                                          const Shape&, const Boundaries<2>&, int,
                                          Population<float, 2>&);
template Point<2> present_normal<float, 2>(const Lattice<2>&, const Layout<2>&,
                                           const FieldStore<float, 2>&, const Cell<2>&,
                                           const Point<2>&);
template void find_ghost_loads<float, 2>(Population<float, 2>&, int);
template kernels::SurfaceLoad<float, 2> mixed_load<float, 2>(const Body<float, 2>&,
                                                             const BlockGhosts<float, 2>&,
                                                             const kernels::GhostFits<float, 2>&,
                                                             std::size_t, const BoundaryValues<2>&);
template void find_record_loads<float, 3>(const Lattice<3>&, const FieldStore<float, 3>&,
                                          const Shape&, const Boundaries<3>&, int,
                                          Population<float, 3>&);
template Point<3> present_normal<float, 3>(const Lattice<3>&, const Layout<3>&,
                                           const FieldStore<float, 3>&, const Cell<3>&,
                                           const Point<3>&);
template void find_ghost_loads<float, 3>(Population<float, 3>&, int);
template kernels::SurfaceLoad<float, 3> mixed_load<float, 3>(const Body<float, 3>&,
                                                             const BlockGhosts<float, 3>&,
                                                             const kernels::GhostFits<float, 3>&,
                                                             std::size_t, const BoundaryValues<3>&);

}  // namespace pliant::remeshed
