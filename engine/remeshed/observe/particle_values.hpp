#pragma once

#include <string>

#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// The field that a measurement names, in a slot of `fields`: those of a body or of its remeshed
/// copy. Strains need several slots and are not included.
template <class T, int D>
double field_value(const Body<T, D>& body, const FieldStore<T, D>& fields, const std::string& field,
                   std::int64_t slot);

/// A Green-Lagrange strain at `x` [m], from the particles or nodes in the cells around `cell` that
/// are near that place: F = (I - grad d)^-1. grad d is the slope of a linear fit of their
/// displacements d over their present places. NaN if there are too few.
template <class T, int D>
double strain_around(const LatticeView<T, D>& around, const Cell<D>& cell, const Point<D>& x,
                     const std::string& field);

/// A field, which may be a strain, at the material point that was at `start` [m] at t = 0: a
/// fit over the particles that started around it. NaN if none remain.
template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, const std::string& field);

}  // namespace pliant::remeshed
