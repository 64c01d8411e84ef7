#include "engine/remeshed/setup.hpp"

#include <cmath>

#include "engine/geometry/signed_distance.hpp"

namespace pliant::remeshed {

template <int D>
Lattice<D> body_lattice(const Case& settings, const BodyCase& body) {
  Lattice<D> lattice;
  const double h = lattice.spacing = settings.discretisation.spacing;
  const Box box = bounding_box(body.geometry);
  for (int a = 0; a < D; ++a) {
    if (settings.periodic.axis[a]) {
      lattice.origin[a] = settings.periodic.lower[a];
      lattice.period[a] = static_cast<std::int32_t>(
          std::lround((settings.periodic.upper[a] - settings.periodic.lower[a]) / h));
      continue;
    }
    const double centre = (box.lower[a] + box.upper[a]) / 2;
    const bool odd = std::lround((box.upper[a] - box.lower[a]) / h) % 2 != 0;
    lattice.origin[a] = odd ? centre - h / 2 : centre;
  }
  return lattice;
}

Vector initial_velocity(const BodyCase& body, const Vector& x) {
  if (const auto* formula = std::get_if<VectorExpression>(&body.velocity)) {
    return {(*formula)[0](x[0], x[1], x[2], 0), (*formula)[1](x[0], x[1], x[2], 0),
            (*formula)[2](x[0], x[1], x[2], 0)};
  }
  const auto& rotation = std::get<RigidRotation>(body.velocity);
  const Vector& w = rotation.angular_velocity;
  const Vector r = {x[0] - rotation.centre[0], x[1] - rotation.centre[1],
                    x[2] - rotation.centre[2]};
  return {w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]};
}

template Lattice<2> body_lattice<2>(const Case&, const BodyCase&);
template Lattice<3> body_lattice<3>(const Case&, const BodyCase&);

}  // namespace pliant::remeshed
