#pragma once

#include <string>

#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// A field of measurements, by its name, in a slot of `fields`: a body's own or those of its
/// remeshed copy. Not strains, which single slots do not know.
template <class T, int D>
double field_value(const Body<T, D>& body, const FieldStore<T, D>& fields, const std::string& field,
                   std::int64_t slot);

/// A Green-Lagrange strain at `x` [m] from the particles or nodes that lie in the cells around
/// `cell` and near the place: F = (I - grad d)^-1, grad d the slope of a linear fit of their
/// displacements d over where they are now. NaN where there are too few.
template <class T, int D>
double strain_around(const LatticeView<T, D>& around, const Cell<D>& cell, const Point<D>& x,
                     const std::string& field);

/// A field at the material point that was at `start` [m] at t = 0, strains too: a linear fit over
/// the particles that started around it. NaN where none remain.
template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, const std::string& field);

}  // namespace pliant::remeshed
