#include "engine/point_based/footprint.hpp"

#include <algorithm>

#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

namespace {

int number_of(const BodyCase& body, const Case& a_case) {
  return static_cast<int>(&body - a_case.bodies.data());
}

bool is_in_contact(const Case& a_case, const BodyCase& body) {
  const int number = number_of(body, a_case);
  return std::ranges::any_of(a_case.contacts, [number](const ContactCase& contact) {
    return std::ranges::count(contact.bodies, number) > 0;
  });
}

/// Corners of the surface per node: h S/V, where S/V is that of a box or a ball of this size.
double corners_of_node(const Case& a_case, const BodyCase& body) {
  const Box<3> box = bounding_box(body.geometry);
  double sum = 0;
  for (int a = 0; a < a_case.dimension; ++a) {
    sum += 2 * a_case.discretisation.spacing / (box.upper[a] - box.lower[a]);
  }
  return std::min(sum, 1.);
}

}  // namespace

Footprint footprint(const Case& a_case, const BodyCase& body) {
  const int dimension = a_case.dimension;
  Footprint footprint;
  footprint.on_corners = true;
  footprint.margin = 1e-9;  // lattice points on the surface count as outside
  footprint.reach = 6;
  // A bond has g, w and the place of the neighbour; a node has fields and a list of candidates.
  const double bond = sizeof(double) * (dimension + 1.0) + 2, candidate = 16;
  footprint.bytes_per_particle =
      neighbour_count(a_case) * (bond + candidate) + sizeof(double) * (8.0 * dimension + 30);
  if (!body.prony.empty()) {
    footprint.bytes_per_particle += sizeof(double) * (static_cast<double>(body.prony.size()) + 1);
  }
  if (!body.prony_shear.empty()) {
    const int components = dimension == 2 ? 4 : 6;
    footprint.bytes_per_particle +=
        sizeof(double) * components * (static_cast<double>(body.prony_shear.size()) + 1);
  }
  // Measured in cases/edge_cut and cases/block_cut: kept gradients, simplices, crossed bonds.
  if (has_cuts(a_case, body)) {
    footprint.bytes_per_particle += dimension == 2 ? 530 : 860;
  } else if (!has_elements(a_case, body)) {
    // Measured with two spheres: fits around the nodes of the surface.
    constexpr double bytes_per_fit = 1900;
    footprint.bytes_per_particle += bytes_per_fit * corners_of_node(a_case, body);
  }
  // Measured with discs and spheres: places, shares, patches, lists.
  constexpr double bytes_per_corner = 2500;
  if (is_in_contact(a_case, body)) {
    footprint.bytes_per_particle += bytes_per_corner * corners_of_node(a_case, body);
  }
  return footprint;
}

}  // namespace pliant::point_based
