#include "engine/remeshed/ghosts/record_loads.hpp"

#include <Eigen/Dense>

#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "engine/remeshed/ghosts/load_finder.hpp"
#include "engine/storage/push_tightly.hpp"

namespace pliant::remeshed {

namespace {

constexpr double unseen = 1e-3;  // of the squares of grad phi; below it they have no direction

}  // namespace

template <class T, int D>
void find_record_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                       const Shape& surface, const Boundaries<D>& boundaries, int block,
                       Population<T, D>& population) {
  const LoadFinder<T, D> finder(lattice, population.layout, fields, surface, boundaries);
  const BlockGhosts<T, D>& ghosts = population.ghosts[block];
  for (std::int32_t r = ghosts.first_record; r < ghosts.first_record + ghosts.record_count; ++r) {
    finder.find(r, population);
  }
}

namespace {

/// Whether two records belong to one face.
template <class T, int D>
bool on_one_face(const Population<T, D>& population, std::int64_t r, std::int64_t s) {
  T cosine = 0;
  for (int a = 0; a < D; ++a) cosine += population.face[r][a] * population.face[s][a];
  return cosine > T(one_face);
}

// The load of the faces of all particles in its fit, if it acts on all of them. The normal of a
// ghost at an edge is no direction of a traction on its faces.
template <class T, int D>
std::int8_t load_of_faces(const Boundaries<D>& boundaries, const Population<T, D>& population,
                          const BlockGhosts<T, D>& ghosts, std::size_t g) {
  const std::int64_t begin = ghosts.begin[g], end = ghosts.begin[g + 1];
  if (begin == end) return no_load;
  const std::int64_t first = kernels::record_of(ghosts.pairs[begin]);
  const std::int8_t load = population.load[first];
  const bool has_direction = boundaries.is_traction(load);
  for (std::int64_t k = begin; k < end; ++k) {
    const std::int64_t record = kernels::record_of(ghosts.pairs[k]);
    if (population.load[record] != load || population.loaded_share[record] < 1) {
      return several_loads;
    }
    if (has_direction && !on_one_face<T, D>(population, first, record)) return several_loads;
  }
  return load;
}

}  // namespace

template <class T, int D>
void find_ghost_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                      const Shape& surface, const Boundaries<D>& boundaries, int block,
                      Population<T, D>& population) {
  const LoadFinder<T, D> finder(lattice, population.layout, fields, surface, boundaries);
  BlockGhosts<T, D>& ghosts = population.ghosts[block];
  const std::size_t faces = ghosts.slot.size() * D;
  assign_tightly(ghosts.face, faces, std::array<T, D>{});
  assign_tightly(ghosts.face_load, faces, no_load);
  assign_tightly(ghosts.face_share, faces, T(0));
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    if (ghosts.wall[g] >= 0) continue;
    ghosts.pressure[g] = load_of_faces<T, D>(boundaries, population, ghosts, g);
    if (ghosts.pressure[g] != several_loads) continue;
    const auto nearest = kernels::record_of(ghosts.pairs[ghosts.begin[g]]);
    finder.find_faces(g, population.slot_of_record[nearest], ghosts);
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

/// A load, and the share of a face on which it acts.
template <class T>
struct LoadOnFace {
  std::int8_t load;
  T share;
};

/// The load on the face of a record: near the ghost, if the face is there, and near the record
/// otherwise.
template <class T, int D>
LoadOnFace<T> load_on_face(const Population<T, D>& population, const BlockGhosts<T, D>& ghosts,
                           std::size_t ghost, std::int64_t record) {
  for (std::size_t k = ghost * D; k < (ghost + 1) * D; ++k) {
    T cosine = 0;
    for (int a = 0; a < D; ++a) cosine += ghosts.face[k][a] * population.face[record][a];
    if (cosine > T(one_face)) return {ghosts.face_load[k], ghosts.face_share[k]};
  }
  return {population.load[record], population.loaded_share[record]};
}

/// The traction of a load along the unit normal n of a face [Pa].
template <class T, int D>
T normal_traction(const LoadPlace<T, D>& place, const BoundaryValues<D>& values, int load,
                  const Column<D>& n) {
  const Point<D> x = place.on_face(n);
  const double along = column<D>(values.traction_at(load, x)).dot(n);
  return static_cast<T>(along - values.pressure_at(load, x));
}

/// The tractions of loads along the normals of the faces around a ghost. Most ghosts have few
/// faces, each of which is met with many particles.
template <class T, int D>
class TractionsOfFaces {
  using Vector = Eigen::Matrix<T, D, 1>;

 public:
  TractionsOfFaces(const LoadPlace<T, D>& place, const BoundaryValues<D>& values)
      : place_(place), values_(values) {}

  /// [Pa]; the normal has any length.
  T along(const Vector& normal, int load) {
    const auto end = known_.begin() + count_;
    const auto at = std::find_if(known_.begin(), end, [&](const Known& known) {
      return known.load == load && known.normal == normal;
    });
    if (at != end) return at->traction;
    Known& known = known_[count_ < static_cast<int>(known_.size()) ? count_++ : 0];
    known = {
        normal, load,
        normal_traction<T, D>(place_, values_, load, normal.normalized().template cast<double>())};
    return known.traction;
  }

 private:
  struct Known {
    Vector normal;
    int load;
    T traction;
  };

  const LoadPlace<T, D>& place_;
  const BoundaryValues<D>& values_;
  std::array<Known, 2 * D> known_;
  int count_ = 0;
};

// The traction of the uniform stress that fits those of the faces along their normals.
template <class T, int D>
kernels::SurfaceLoad<T, D> mixed_load(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                      const kernels::GhostFits<T, D>& fits, std::size_t ghost,
                                      const LoadPlace<T, D>& place,
                                      const BoundaryValues<D>& values) {
  using Vector = Eigen::Matrix<T, D, 1>;
  using Matrix = Eigen::Matrix<T, D, D>;
  const Matrix turn = turn_of_normals(body, ghosts, ghost);
  TractionsOfFaces<T, D> tractions(place, values);
  Matrix squares = Matrix::Zero(), products = Matrix::Zero();
  for (std::int64_t k = ghosts.begin[ghost]; k < ghosts.begin[ghost + 1]; ++k) {
    const std::int64_t record = kernels::record_of(ghosts.pairs[k]);
    const auto [load, share] = load_on_face(body.population, ghosts, ghost, record);
    const T w = FittedParticle<T, D>(ghosts, ghost, k).weight();
    const Vector face = Eigen::Map<const Vector>(body.population.face[record].data());
    const Vector normal = face + turn * face;
    const Matrix square = normal * normal.transpose();
    squares += w * square;
    if (load >= 0) products += w * share * tractions.along(normal, load) * square;
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

template <class T, int D>
kernels::SurfaceLoad<T, D> single_load(const kernels::GhostFits<T, D>& fits, int load,
                                       const LoadPlace<T, D>& place,
                                       const BoundaryValues<D>& values) {
  kernels::SurfaceLoad<T, D> result{kernels::unit_normal<T, D>(fits.linear), 0, {}};
  const Eigen::Map<const Eigen::Matrix<T, D, 1>> n(result.n.data());
  result.normal = normal_traction<T, D>(place, values, load, n.template cast<double>());
  return result;
}

}  // namespace

template <class T, int D>
kernels::SurfaceLoad<T, D> load_on_ghost(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                         const kernels::GhostFits<T, D>& fits, std::size_t ghost,
                                         const LoadPlace<T, D>& place,
                                         const BoundaryValues<D>& values) {
  const int load = ghosts.pressure[ghost];
  return load == several_loads ? mixed_load(body, ghosts, fits, ghost, place, values)
                               : single_load(fits, load, place, values);
}

template void find_record_loads<double, 2>(const Lattice<2>&, const FieldStore<double, 2>&,
                                           const Shape&, const Boundaries<2>&, int,
                                           Population<double, 2>&);
template void find_ghost_loads<double, 2>(const Lattice<2>&, const FieldStore<double, 2>&,
                                          const Shape&, const Boundaries<2>&, int,
                                          Population<double, 2>&);
template kernels::SurfaceLoad<double, 2> load_on_ghost(const Body<double, 2>&,
                                                       const BlockGhosts<double, 2>&,
                                                       const kernels::GhostFits<double, 2>&,
                                                       std::size_t, const LoadPlace<double, 2>&,
                                                       const BoundaryValues<2>&);
template void find_record_loads<double, 3>(const Lattice<3>&, const FieldStore<double, 3>&,
                                           const Shape&, const Boundaries<3>&, int,
                                           Population<double, 3>&);
template void find_ghost_loads<double, 3>(const Lattice<3>&, const FieldStore<double, 3>&,
                                          const Shape&, const Boundaries<3>&, int,
                                          Population<double, 3>&);
template kernels::SurfaceLoad<double, 3> load_on_ghost(const Body<double, 3>&,
                                                       const BlockGhosts<double, 3>&,
                                                       const kernels::GhostFits<double, 3>&,
                                                       std::size_t, const LoadPlace<double, 3>&,
                                                       const BoundaryValues<3>&);
template void find_record_loads<float, 2>(const Lattice<2>&, const FieldStore<float, 2>&,
                                          const Shape&, const Boundaries<2>&, int,
                                          Population<float, 2>&);
template void find_ghost_loads<float, 2>(const Lattice<2>&, const FieldStore<float, 2>&,
                                         const Shape&, const Boundaries<2>&, int,
                                         Population<float, 2>&);
template kernels::SurfaceLoad<float, 2> load_on_ghost(const Body<float, 2>&,
                                                      const BlockGhosts<float, 2>&,
                                                      const kernels::GhostFits<float, 2>&,
                                                      std::size_t, const LoadPlace<float, 2>&,
                                                      const BoundaryValues<2>&);
template void find_record_loads<float, 3>(const Lattice<3>&, const FieldStore<float, 3>&,
                                          const Shape&, const Boundaries<3>&, int,
                                          Population<float, 3>&);
template void find_ghost_loads<float, 3>(const Lattice<3>&, const FieldStore<float, 3>&,
                                         const Shape&, const Boundaries<3>&, int,
                                         Population<float, 3>&);
template kernels::SurfaceLoad<float, 3> load_on_ghost(const Body<float, 3>&,
                                                      const BlockGhosts<float, 3>&,
                                                      const kernels::GhostFits<float, 3>&,
                                                      std::size_t, const LoadPlace<float, 3>&,
                                                      const BoundaryValues<3>&);

}  // namespace pliant::remeshed
