#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/point_based/body.hpp"
#include "engine/point_based/cutting/crossing.hpp"

/// Fields that measurements name, at nodes and between them.
namespace pliant::point_based {

/// The value of a field at the place `start` of the undeformed body [m]: a fit to the node at
/// `nearest` and its neighbours. The neighbours have bonds with it, so no value comes from beyond a
/// cut.
template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, std::int64_t nearest,
                      const std::string& field);

/// The displacement of the material point `start` [m] along an axis, from the node at `nearest` and
/// its neighbours on the same side of all cuts, (PB.64) [m].
template <class T, int D>
double point_displacement(const Body<T, D>& body, const Vector& start, std::int64_t nearest,
                          int axis, std::span<const CutSurface<D>> cuts);

/// The mean of the field of a `mean_value`, over the present volume of the nodes that the
/// measurement selects. NaN where there are none.
template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double t);

/// Undeformed place of the material now at `x` [m], by the gradient at the node that is now
/// nearest.
template <class T, int D>
Vector start_of(const Body<T, D>& body, const Vector& x);

}  // namespace pliant::point_based
