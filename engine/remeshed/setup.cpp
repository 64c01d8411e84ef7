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

template Lattice<2> body_lattice<2>(const Case&, const BodyCase&);
template Lattice<3> body_lattice<3>(const Case&, const BodyCase&);

}  // namespace pliant::remeshed
