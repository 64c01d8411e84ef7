#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/point_based/body.hpp"

/// Fields that measurements name, at nodes and between them.
namespace pliant::point_based {

/// The value of a field at the place `start` of the undeformed body [m]: a linear fit to the node
/// at `nearest` and those that have bonds with it, so that no value comes from beyond a cut.
template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, std::int64_t nearest,
                      const std::string& field);

/// The mean of the field of a `mean_value` over the present volume of the nodes that lie where the
/// measurement says. NaN where there are none.
template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double t);

/// Where the material now at `x` [m] started, as the gradient at the node that is nearest now says.
template <class T, int D>
Vector start_of(const Body<T, D>& body, const Vector& x);

}  // namespace pliant::point_based
