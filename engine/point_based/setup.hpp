#pragma once

#include "engine/point_based/nodes/node_cloud.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// The constants that the kernels read.
template <class T>
kernels::PointMaterial<T> point_material(const BodyCase& source);

/// Makes a body of a case from the nodes of its cloud, at rest or with the case's initial velocity.
/// `reach` is the distance within which a wall holds a node, over the node's V^(1/D). Throws
/// InputError for a cloud that is no body.
template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const NodeCloud<D>& cloud,
               const Boundaries<D>& boundaries, double reach, double alpha, Body<T, D>& body);

/// Nodes of a body of a case on a lattice, and all that follows from them.
template <class T, int D>
void make_lattice_body(const Case& settings, const BodyCase& source,
                       const Boundaries<D>& boundaries, Body<T, D>& body);

}  // namespace pliant::point_based
