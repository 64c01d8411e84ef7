#pragma once

#include <optional>
#include <string>

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// The value of a field at the place `start` of the undeformed body [m], from a fit over the cells
/// around it. NaN where there are none.
template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, const std::string& field);

/// Undeformed place of the material that is now at `x` [m], from the nearest cell; none if no cell
/// is near.
template <class T, int D>
std::optional<Vector> start_of(const Body<T, D>& body, const Vector& x);

/// The mean of the field of a `mean_value`, over the present volume of the cells that the
/// measurement selects. NaN where there are none.
template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double t);

}  // namespace pliant::total_lagrangian
