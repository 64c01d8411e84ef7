#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "engine/case/case.hpp"

namespace pliant {

struct Check;

/// What reading a case needs to know of a method.
struct MethodRules {
  std::string_view word;     ///< as case files write it
  std::string_view meaning;  ///< for the reference of case files
  /// Adds what the case asks for and the method cannot do.
  void (*check)(const Check& check);
};

/// The methods that a case may name.
using MethodList = std::span<const MethodRules>;

/// Adds a problem for each measurement that the method cannot evaluate, and that does not evaluate
/// the history of another one.
void refuse_measurements(const Check& check, bool (*is_measured)(MeasurementCase::Kind kind));

/// Adds a problem for each boundary of this kind.
void refuse_boundaries(const Check& check, BoundaryCase::Kind kind);

/// Adds a problem for a key at the top level of the case.
void refuse_key(const Check& check, std::string_view key);

/// Adds a problem for each body whose material is for the point-based method alone.
void refuse_models_of_points(const Check& check);

/// Adds a problem for each of these tables that the case contains.
void refuse_tables(const Check& check, std::initializer_list<std::string_view> tables);

}  // namespace pliant
