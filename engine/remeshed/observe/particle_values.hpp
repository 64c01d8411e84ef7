#pragma once

#include <string>

#include "engine/remeshed/body.hpp"

namespace pliant::remeshed {

/// A field of measurements, by its name, in a slot of `fields`: a body's own or those of its
/// remeshed copy. Strains are not known in single slots.
template <class T, int D>
double field_value(const Body<T, D>& body, const FieldStore<T, D>& fields, const std::string& field,
                   std::int64_t slot);

/// The same at the material point that was at `start` [m] at t = 0, strains too: a linear fit over
/// the particles that started around it. NaN where none remain.
template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, const std::string& field);

}  // namespace pliant::remeshed
