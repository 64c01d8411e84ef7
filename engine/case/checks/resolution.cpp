#include "engine/case/checks/resolution.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/case/method_rules.hpp"
#include "engine/geometry/volume_mesh.hpp"

namespace pliant {

namespace {

double mean_size(const Shape& shape, int dimension) {
  const VolumeMesh mesh = read_volume_mesh(shape.file, dimension);
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) volume += element_volume(mesh, e);
  const int elements_of_cube = dimension == 2 ? 2 : 6;
  return shape.scale *
         std::pow(elements_of_cube * volume / static_cast<double>(mesh.elements.size()),
                  1. / dimension);
}

}  // namespace

std::string Resolution::remedy(double enough) const {
  return of_elements ? fmt::format("use a finer mesh (elements of {:.3g} m or below)", enough)
                     : fmt::format("use a finer spacing (discretisation.spacing = {:.3g} or below)",
                                   enough);
}

Resolution resolution_of(const Case& a_case, const BodyCase& body) {
  if (has_elements(a_case, body)) return {mean_size(body.geometry, a_case.dimension), true};
  return {a_case.discretisation.spacing, false};
}

}  // namespace pliant
