#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "engine/case/method_rules.hpp"
#include "engine/case/vocabulary/word.hpp"

/// What the vocabulary says about a key, and wrappers for values that a file writes differently
/// from `Case`.
namespace pliant {

/// Allowed values of a number, or of every number of a list.
struct Limits {
  double lower, upper;
  bool lower_included, upper_included;
  std::string_view text;  ///< as in "youngs_modulus must be ..."

  constexpr bool admit(double value) const {
    return (lower_included ? value >= lower : value > lower) &&
           (upper_included ? value <= upper : value < upper);
  }
};

inline constexpr double unlimited = std::numeric_limits<double>::infinity();
inline constexpr Limits finite{-unlimited, unlimited, false, false, "finite"};
inline constexpr Limits finite_or_infinite{-unlimited, unlimited, true, true,
                                           "finite, inf or -inf"};
inline constexpr Limits positive{0, unlimited, false, false, "positive"};
inline constexpr Limits not_negative{0, unlimited, true, false, "0 or more"};
inline constexpr Limits at_least_one{1, unlimited, true, false, "1 or more"};

/// Everything about a key except its name and type. Its default is the value in a
/// default-constructed case.
struct Notes {
  std::string_view meaning;
  std::string_view unit = {};
  std::string_view example = {};  ///< a value, as TOML text
  Limits limits = finite;
  bool required = false;
  bool decides = false;  ///< whether its value decides which other keys the table has
  std::string_view variables = "xyzt";  ///< available to a formula
  std::string_view remedy = {};         ///< if a number is outside its limits; empty: the example
};

struct Name {  ///< letters, digits, _ and -
  std::string& text;
};
struct MethodWord {  ///< the word of a method
  std::string& word;
  MethodList known;
};
struct FilePath {  ///< relative to the folder of the case file
  std::string& text;
};
struct Coefficients {  ///< C_10, C_20, ...
  std::vector<double>& list;
};
struct NumberOrWord {
  std::optional<double>& number;  ///< none: the word
  std::string_view word;
  std::string_view noun;  ///< name of the number, as in "a time step"
};
struct Choice {  ///< one of some words
  int& value;
  std::span<const Word> known;
};
struct CflRule {  ///< a number; none: that of the method
  std::optional<double>& cfl;
};
struct Dissipation {  ///< a table, or a number for both strengths
  DissipationCase& strengths;
};
struct RemeshRule {  ///< a number of steps, "adaptive" or "never"
  decltype(Case::remeshing)& remeshing;
};
struct AxisSet {  ///< ["x", "y"]
  std::array<bool, 3>& axis;
};
struct Direction {  ///< a vector of any non-zero length; the case stores the unit vector
  Vector& vector;
};
struct AngularVelocity {  ///< a number in 2D, a vector in 3D
  Vector& vector;
};
struct BodyName {
  int& index;
};
struct BodyPair {  ///< the names of two bodies
  std::array<int, 2>& indices;
};
struct BoundaryName {
  int& index;
};
struct CutName {
  int& index;
};
struct MeasurementName {
  int& index;
};
struct WallFriction {  ///< a contact law that lets bodies separate, or a coefficient
  BoundaryCase& boundary;
};
struct MeasurementNames {
  std::vector<int>& indices;
};
struct FieldName {
  std::string& field;
};

}  // namespace pliant
