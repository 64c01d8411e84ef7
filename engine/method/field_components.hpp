#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "engine/lattice/lattice.hpp"
#include "engine/method/full_stress.hpp"

/// Values of the fields that measurements name, computed from stress and strain at a point.
namespace pliant {

/// Axes at the end of a field's name, as in `stress_xy`: 0..2.
inline int last_axis(std::string_view field) { return field.back() - 'x'; }
inline int first_axis(std::string_view field) { return field[field.size() - 2] - 'x'; }

/// `von_mises_stress`, or a component such as `stress_xy`, of a stress in the order of full_stress
/// [Pa].
inline double stress_value(const std::array<double, 6>& s, std::string_view field) {
  if (field == "von_mises_stress") {
    const double normal =
        std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2);
    return std::sqrt(normal / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
  const int i = first_axis(field), j = last_axis(field);
  return i == j ? s[i] : s[i + j == 1 ? 3 : i + j == 3 ? 4 : 5];
}

/// A component, such as `strain_xy`, of the Green-Lagrange strain (F^T F - I)/2.
template <int D>
double strain_value(const std::array<Point<D>, D>& deformation_gradient, std::string_view field) {
  const int i = first_axis(field), j = last_axis(field);
  double sum = i == j ? -1 : 0;
  for (int k = 0; k < D; ++k) sum += deformation_gradient[k][i] * deformation_gradient[k][j];
  return sum / 2;
}

}  // namespace pliant
