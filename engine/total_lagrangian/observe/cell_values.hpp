#pragma once

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// The field of a `material_value` at the material point that was at `m.point` at t = 0: a linear
/// fit over the cells around it. NaN where there are none.
template <class T, int D>
double material_value(const Body<T, D>& body, const MeasurementCase& m, double hourglass);

/// The mean of the field of a `mean_value` over the present volume of the cells that lie where the
/// measurement says. NaN where there are none.
template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double hourglass, double t);

}  // namespace pliant::total_lagrangian
