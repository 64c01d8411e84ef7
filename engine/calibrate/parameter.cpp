#include "engine/calibrate/parameter.hpp"

#include <algorithm>
#include <cmath>

namespace pliant::calibrate {

double Parameter::value(double angle) const {
  const double share = (1 + std::sin(angle)) / 2;
  return logarithmic ? lower * std::pow(upper / lower, share) : lower + (upper - lower) * share;
}

double Parameter::angle(double value) const {
  const double share = logarithmic ? std::log(value / lower) / std::log(upper / lower)
                                   : (value - lower) / (upper - lower);
  return std::asin(std::clamp(2 * share - 1, -1.0, 1.0));
}

double Parameter::slope(double angle) const {
  const double share = std::cos(angle) / 2;
  return logarithmic ? value(angle) * std::log(upper / lower) * share : (upper - lower) * share;
}

}  // namespace pliant::calibrate
