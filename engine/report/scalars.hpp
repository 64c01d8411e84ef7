#pragma once

#include <string>
#include <vector>

#include "engine/output/results/field_arrays.hpp"

namespace pliant::report {

/// A number on every point, taken from a field of a result file.
struct Scalar {
  enum class Kind { value, magnitude, von_mises, component };

  std::string name;   ///< "velocity", "velocity_y", "von_mises_stress"
  std::string label;  ///< for people
  std::string unit;   ///< SI, "1" for a pure number
  std::string field;  ///< in the file
  Kind kind = Kind::value;
  int component = 0;
};

/// What a report shows when it is not told: displacement, velocity and stress first.
std::vector<Scalar> default_scalars(const std::vector<StoredField>& fields);

/// A field by name, its magnitude where it is a vector; or a component, as in velocity_y. Throws
/// InputError, which lists the names.
Scalar scalar_named(const std::string& name, const std::vector<StoredField>& fields);

/// The number at one point, from the components of its field.
float value_of(const Scalar& scalar, const float* components);

}  // namespace pliant::report
