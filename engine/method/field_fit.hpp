#pragma once

#include <algorithm>
#include <optional>

#include "engine/method/polynomial_fit.hpp"

namespace pliant {

/// The weight of a value at a distance, over the radius within which values count.
inline double weight_of_value(double square, double radius) {
  const double left = std::max(0., 1 - square / (radius * radius));
  return left * left;
}

/// The value of a field at a point, from values around it: by a quadratic fit where they determine
/// one well, otherwise by a linear one.
template <int D>
class FieldFit {
 public:
  /// Adds the value at one place; `r` is the vector from the point to it, in any unit.
  void add(const Point<D>& r, double linear_weight, double quadratic_weight, double value) {
    linear_.add(r, linear_weight, {value});
    quadratic_.add(r, quadratic_weight, {value});
  }

  /// None where the values do not determine even a linear fit.
  std::optional<double> value() {
    // Amplification of a quadratic fit: 3 to 5 among particles of a lattice, but 14 on a face, half
    // a spacing beyond the last row, where the fit is therefore linear. It is also above 4 among
    // few irregular nodes, whose values differ at random. The transition is smooth, so that
    // histories do not jump when particles pass.
    constexpr double wholly_quadratic = 4, wholly_linear = 8;
    if (!linear_.solve()) return std::nullopt;
    if (!quadratic_.solve()) return linear_.value(0);
    const double share = std::clamp(
        (wholly_linear - quadratic_.amplification()) / (wholly_linear - wholly_quadratic), 0., 1.);
    return linear_.value(0) + share * (quadratic_.value(0) - linear_.value(0));
  }

 private:
  LinearFit<D, 1> linear_;
  QuadraticFit<D, 1> quadratic_;
};

}  // namespace pliant
