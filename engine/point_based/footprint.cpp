#include "engine/point_based/footprint.hpp"

#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

Footprint footprint(const Case& a_case, const BodyCase&) {
  const int dimension = a_case.dimension;
  Footprint footprint;
  footprint.on_corners = true;
  footprint.margin = 1e-9;  // points of the lattice on the surface lie outside
  footprint.reach = 6;
  footprint.bytes_per_particle =
      neighbour_count(a_case) * (sizeof(double) * (dimension + 1.0) + 2) +
      sizeof(double) * (6.0 * dimension + 30) + 700;
  return footprint;
}

}  // namespace pliant::point_based
