#pragma once

#include <string>
#include <vector>

#include "engine/output/results/field_arrays.hpp"

namespace pliant::report {

/// A scalar on every point, from a field of a result file.
struct Scalar {
  enum class Kind { value, magnitude, von_mises, component };

  std::string name;   ///< "velocity", "velocity_y", "von_mises_stress"
  std::string label;  ///< for users
  std::string unit;   ///< SI, "1" for a pure number
  std::string field;  ///< in the file
  Kind kind = Kind::value;
  int component = 0;
};

/// The default scalars of a report: displacement, velocity and stress come first.
std::vector<Scalar> default_scalars(const std::vector<StoredField>& fields);

/// A field by name (for a vector its magnitude), or a component such as velocity_y. Throws
/// InputError that lists the names.
Scalar scalar_named(const std::string& name, const std::vector<StoredField>& fields);

/// The scalar at one point, from the components of its field.
float value_of(const Scalar& scalar, const float* components);

}  // namespace pliant::report
