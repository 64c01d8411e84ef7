#include "engine/case/writing/validate_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/case/checks/stability.hpp"
#include "engine/case/vocabulary/vocabulary.hpp"
#include "engine/geometry/closed_mesh.hpp"
#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {
namespace {

/// Area or volume of a body inside the periodic cell, from the midpoints of a grid; exact for
/// boxes.
double measure(const BodyCase& body, const Case& a_case) {
  Box<3> box = bounding_box(body.geometry);
  const int cells = a_case.dimension == 2 ? 1024 : 96;
  double cell = 1;
  for (int i = 0; i < a_case.dimension; ++i) {
    if (a_case.periodic.axis[i]) {
      box.lower[i] = std::max(box.lower[i], a_case.periodic.lower[i]);
      box.upper[i] = std::min(box.upper[i], a_case.periodic.upper[i]);
    }
    cell *= (box.upper[i] - box.lower[i]) / cells;
  }
  double sum = 0;
  DistanceWalk inside(body.geometry, a_case.dimension, 0);
  for (int z = 0; z < (a_case.dimension == 2 ? 1 : cells); ++z) {
    for (int y = 0; y < cells; ++y) {
      for (int x = 0; x < cells; ++x) {
        const std::array<int, 3> index{x, y, z};
        Vector point{};
        for (int i = 0; i < a_case.dimension; ++i) {
          point[i] = box.lower[i] + (box.upper[i] - box.lower[i]) * (index[i] + 0.5) / cells;
        }
        if (inside(point) < 0) sum += cell;
      }
    }
  }
  return sum;
}

/// One line for each mesh of a shape; reading has shown that it is closed.
std::string mesh_lines(const Shape& shape) {
  std::string text;
  for (const Shape& part : shape.operands) text += mesh_lines(part);
  if (shape.kind != Shape::Kind::mesh) return text;
  const Box<3>& box = shape.mesh->bounds();
  return text + fmt::format(
                    "    mesh {}: closed, {} triangles ({} without area dropped), {:.6g} m^3, "
                    "from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})\n",
                    std::filesystem::path(shape.file).filename().string(),
                    shape.mesh->triangles().size(), shape.mesh->dropped(), shape.mesh->volume(),
                    box.lower[0], box.lower[1], box.lower[2], box.upper[0], box.upper[1],
                    box.upper[2]);
}

std::string model_name(const BodyCase& body) {
  const MaterialCase& material = body.material_as_given;
  if (material.model == MaterialCase::Model::reduced_polynomial) {
    std::string text = fmt::format("reduced polynomial of order {}", body.material.order);
    const std::size_t terms = body.prony.size() + body.prony_shear.size();
    if (terms == 0) return text;
    return text + fmt::format(" with {} Prony term{}", terms, terms == 1 ? "" : "s");
  }
  if (material.model == MaterialCase::Model::neo_hookean) return "neo-Hookean";
  if (material.model == MaterialCase::Model::st_venant_kirchhoff) return "St. Venant-Kirchhoff";
  return fmt::format("linear elastic, {} equation of state", text_of(material.equation_of_state));
}

std::string method_text(const Case& a_case) {
  const bool has_summary = a_case.rules != nullptr && a_case.rules->summary != nullptr;
  return has_summary ? a_case.rules->summary(a_case) : a_case.method;
}

}  // namespace

std::string validate_summary(const Case& a_case, std::optional<double> step_of_setup) {
  std::string text = fmt::format("{}: {}, {}D, spacing {} m\n", a_case.name,
                                 a_case.title.empty() ? "no title" : a_case.title, a_case.dimension,
                                 a_case.discretisation.spacing);
  const double cell = std::pow(a_case.discretisation.spacing, a_case.dimension);
  double fastest = 0;
  for (const BodyCase& body : a_case.bodies) {
    const double waves = scaled_wave_speed(a_case, body);
    fastest = std::max(fastest, waves);
    text += fmt::format("  body {}: ", body.name);
    if (!step_of_setup)
      text += fmt::format("about {:.0f} particles, ", measure(body, a_case) / cell);
    text += fmt::format("{}, waves at {:.4g} m/s\n", model_name(body), waves);
    text += mesh_lines(body.geometry);
  }
  for (const BoundaryCase& boundary : a_case.boundaries) {
    text += fmt::format("  boundary {}: {}\n", boundary.name, row_of(boundary.kind).word);
    text += mesh_lines(boundary.geometry);
  }
  // (RP.29) at rest
  const double cfl_step = cfl_number(a_case) * a_case.discretisation.spacing / fastest;
  const double step = step_of_setup.value_or(a_case.time.step.value_or(cfl_step));
  text += fmt::format("  time: {} s in about {:.0f} steps of {:.3g} s", a_case.time.end,
                      std::ceil(a_case.time.end / step), step);
  if (!step_of_setup) {
    text += fmt::format(" (CFL number {:.2g})", step * fastest / a_case.discretisation.spacing);
  }
  text += fmt::format(", {}\n", method_text(a_case));
  std::vector<std::string> names;
  for (const MeasurementCase& measurement : a_case.measurements) names.push_back(measurement.name);
  text += fmt::format("  measurements: {}\n",
                      names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
  return text;
}

}  // namespace pliant
