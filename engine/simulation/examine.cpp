#include "engine/simulation/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "engine/case/checks/stability.hpp"
#include "engine/finite_elements/solver.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/decompositions.hpp"
#include "engine/point_based/solver.hpp"
#include "engine/point_based/surface/contact_surface.hpp"

namespace pliant {

namespace {

/// Volume inside a surface, by Gauss's theorem.
template <int D>
double enclosed_volume(const point_based::BodySurface<D>& surface) {
  double sum = 0;
  for (const auto& facet : surface.facet) {
    std::array<Point<D>, D> corner;
    for (int v = 0; v < D; ++v) corner[v] = surface.start[facet[v]];
    const Point<D> middle = undeformed::middle_of<D>(corner);
    const Point<D> area = undeformed::area_vector<D>(corner);
    for (int a = 0; a < D; ++a) sum += area[a] * middle[a] / D;
  }
  return sum;
}

/// Condition number of the moment matrix of a node; 0 without a matrix.
template <int D>
double condition_of(const point_based::Body<double, D>& body, std::int64_t slot) {
  Eigen::Matrix<double, D, D> moment;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      moment(i, j) = body.moment[kernels::symmetric_index<D>(i, j)][slot];
    }
  }
  const auto values = eigenvalues<D>(moment);
  const double most = values[D - 1];
  return most > 0 ? most / std::max(values[0], 1e-16 * most) : 0;
}

template <int D>
ExaminedBody examine_body(const point_based::Body<double, D>& body) {
  ExaminedBody found;
  found.name = body.name;
  found.nodes = body.particles;
  found.volume = body.volume_at_rest;
  found.enclosed_volume = enclosed_volume<D>(body.surface);
  body.for_each_node([&](std::int64_t slot) {
    const double condition = condition_of<D>(body, slot);
    if (condition <= found.condition) return;
    found.condition = condition;
    found.worst = padded<D>(body.start[slot]);
  });
  for (const auto& of_block : body.degenerate) {
    found.degenerate += static_cast<std::int64_t>(of_block.size());
  }
  return found;
}

template <int D>
using Surfaces = std::vector<undeformed::ContactSurface<D>>;

/// Adds the corners and facets of a surface to a contact.
template <int D>
void add_surface(const undeformed::ContactSurface<D>& surface, const std::string& name,
                 ExaminedContact& contact) {
  contact.names.push_back(name);
  contact.corners.push_back(surface.corners());
  contact.facets.push_back(static_cast<std::int64_t>(surface.facet.size()));
}

/// Finds the deepest corner of a surface inside a solid.
template <int D>
void find_penetration(const undeformed::ContactSurface<D>& surface, const Shape& solid,
                      ExaminedContact& contact) {
  for (const Point<D>& corner : surface.start) {
    const double depth = -signed_distance(solid, padded<D>(corner), D);
    if (depth <= contact.penetration) continue;
    contact.penetration = depth;
    contact.deepest = padded<D>(corner);
  }
}

template <int D>
std::vector<ExaminedContact> contacts_of_bodies(const Case& a_case, const Surfaces<D>& surfaces) {
  std::vector<ExaminedContact> found;
  for (const ContactCase& contact : a_case.contacts) {
    ExaminedContact& examined = found.emplace_back();
    const auto [a, b] = contact.bodies;
    add_surface<D>(surfaces[a], a_case.bodies[a].name, examined);
    if (a == b) continue;
    add_surface<D>(surfaces[b], a_case.bodies[b].name, examined);
    find_penetration<D>(surfaces[a], a_case.bodies[b].geometry, examined);
    find_penetration<D>(surfaces[b], a_case.bodies[a].geometry, examined);
  }
  return found;
}

template <int D>
std::vector<ExaminedContact> contacts_of_walls(const Case& a_case, const Surfaces<D>& surfaces) {
  std::vector<ExaminedContact> found;
  for (const BoundaryCase& boundary : a_case.boundaries) {
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    for (std::size_t b = 0; b < surfaces.size(); ++b) {
      ExaminedContact& examined = found.emplace_back();
      add_surface<D>(surfaces[b], a_case.bodies[b].name, examined);
      examined.names.push_back(boundary.name);
      find_penetration<D>(surfaces[b], boundary.geometry, examined);
    }
  }
  return found;
}

template <int D>
std::vector<ExaminedContact> examine_contacts(
    const Case& a_case, const std::vector<point_based::Body<double, D>>& bodies) {
  Surfaces<D> surfaces;
  for (const auto& body : bodies) surfaces.push_back(contact_surface(body));
  std::vector<ExaminedContact> found = contacts_of_bodies<D>(a_case, surfaces);
  for (ExaminedContact& contact : contacts_of_walls<D>(a_case, surfaces)) {
    found.push_back(std::move(contact));
  }
  return found;
}

// For these methods, the stability limit is a CFL number of 1.
template <class Solver>
Examined examine_with(Case a_case) {
  Examined found;
  const std::optional<double> given_step = a_case.time.step;
  const double cfl = cfl_number(a_case);
  a_case.precision = Precision::binary64;
  a_case.time.step.reset();
  a_case.time.cfl = 1;
  const Solver solver(a_case, {.threads = 1});
  for (const auto& body : solver.state().bodies) found.bodies.push_back(examine_body(body));
  found.contacts = examine_contacts(solver.settings(), solver.state().bodies);
  found.stable_step = solver.time_step();
  found.time_step = given_step.value_or(cfl * found.stable_step);
  return found;
}

}  // namespace

std::string ExaminedBody::text() const {
  std::string line =
      fmt::format("nodes: {} in body \"{}\", their volumes {:+.2g} % off the enclosed volume",
                  nodes, name, 100 * volume_error());
  if (condition > 0) {
    line += fmt::format(", worst condition of neighbours {:.3g} at ({:.4g}, {:.4g}, {:.4g})",
                        condition, worst[0], worst[1], worst[2]);
  }
  if (degenerate > 0) {
    line += fmt::format(", {} with neighbours on a plane or a line only", degenerate);
  }
  return line;
}

std::string ExaminedContact::text() const {
  std::string line = "contact of";
  for (std::size_t i = 0; i < names.size(); ++i) {
    line += fmt::format("{} \"{}\"", i == 0 ? "" : " and", names[i]);
    if (i < corners.size()) line += fmt::format(" ({} corners, {} facets)", corners[i], facets[i]);
  }
  if (names.size() == 1) return line + " with itself";
  if (penetration == 0) return line + ", apart at the start";
  return line +
         fmt::format(", {:.2g} m deep in each other at the start, at ({:.4g}, {:.4g}, {:.4g})",
                     penetration, deepest[0], deepest[1], deepest[2]);
}

std::string Examined::step_text() const {
  return fmt::format("time step: {:.4g} s, stable up to {:.4g} s{}", time_step, stable_step,
                     contacts.empty() ? "" : "; contact does not shorten it");
}

std::string Examined::stability_warning() const {
  if (!(time_step > stable_step)) return "";
  return fmt::format(
      "the time step {:.4g} s is above the stability limit of {:.3g} s; set time.step = \"cfl\", "
      "or to less than the limit",
      time_step, stable_step);
}

std::optional<Examined> examine(const Case& a_case) {
  if (a_case.method == "point_based") {
    return a_case.dimension == 2 ? examine_with<point_based::Solver<double, 2>>(a_case)
                                 : examine_with<point_based::Solver<double, 3>>(a_case);
  }
  if (a_case.method == "finite_elements") {
    return examine_with<finite_elements::Solver<double, 3>>(a_case);
  }
  return std::nullopt;
}

}  // namespace pliant
