#include "engine/point_based/nodes/place_nodes.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/nodes/body_lattice.hpp"
#include "engine/point_based/nodes/cut_places.hpp"
#include "engine/point_based/nodes/lattice_nodes.hpp"
#include "engine/point_based/nodes/mesh_nodes.hpp"
#include "engine/point_based/nodes/nodes_at_walls.hpp"
#include "engine/point_based/nodes/octree_nodes.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

bool has_elements(const Shape& shape) {
  return shape.kind == Shape::Kind::mesh &&
         (shape.file.ends_with(".msh") || shape.file.ends_with(".vtk"));
}

namespace {

template <int D>
std::vector<double> half_of_spacings(const NodeCloud<D>& cloud) {
  std::vector<double> half;
  for (const double volume : cloud.volumes) half.push_back(std::pow(volume, 1. / D) / 2);
  return half;
}

}  // namespace

template <int D>
PlacedNodes<D> place_nodes(const Case& settings, const BodyCase& source,
                           const Boundaries<D>& boundaries) {
  const Shape& shape = source.geometry;
  const double spacing = settings.discretisation.spacing;
  std::optional<Point<D>> pitch;
  PlacedNodes<D> nodes;
  if (has_elements(shape)) {
    nodes.cloud = nodes_of_mesh<D>(read_volume_mesh(shape.file, D), shape.scale, shape.translate);
    nodes.reach = reach_of_walls<D>(nodes.cloud);
    nodes.alpha = 0.2;
  } else if (parameters_of(settings).nodes == NodePlacement::octree) {
    const double coarsest = parameters_of(settings).coarsest_spacing;
    pitch = lattice_pitch<D>(shape, spacing);
    nodes.cloud = octree_nodes<D>(shape, {spacing, coarsest > 0 ? coarsest : 4 * spacing},
                                  CutPlaces<D>(settings, source, spacing / 2).take());
    nodes.reach = half_of_spacings<D>(nodes.cloud);
  } else {
    pitch = lattice_pitch<D>(shape, spacing);
    nodes.cloud = lattice_nodes<D>(shape, spacing);
    nodes.reach = half_of_spacings<D>(nodes.cloud);
    // Nodes at the surface have fewer neighbours, not farther ones, which would soften bending.
    const double widest = *std::max_element(pitch->begin(), pitch->end());
    for (int a = 0; a < D; ++a) nodes.stretch[a] = widest / (*pitch)[a];
    nodes.support = widest * lattice_support<D>(neighbour_count(settings));
    nodes.alpha = 0.1;
  }
  if (nodes.cloud.positions.empty()) {
    throw InputError(
        fmt::format("body `{}` holds no node; use a finer discretisation.spacing", source.name));
  }
  nodes.elastic_volumes = nodes.cloud.elements.empty()
                              ? fit_to_walls<D>(boundaries, shape, pitch, nodes.cloud)
                              : volumes_of_free_elements<D>(boundaries, nodes.reach, nodes.cloud);
  return nodes;
}

template PlacedNodes<2> place_nodes<2>(const Case&, const BodyCase&, const Boundaries<2>&);
template PlacedNodes<3> place_nodes<3>(const Case&, const BodyCase&, const Boundaries<3>&);

}  // namespace pliant::point_based
