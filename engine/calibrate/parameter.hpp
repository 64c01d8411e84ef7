#pragma once

#include <string>

namespace pliant::calibrate {

/// A value of the case that is to be found between two bounds.
///
/// The optimiser has no bounds. It uses an angle u instead: the value is lower + (upper - lower)(1
/// + sin u)/2, or the same with logarithms.
struct Parameter {
  std::string key;  ///< of the case, as for --set
  double start = 1, lower = 0, upper = 2;
  bool logarithmic = false;

  double value(double angle) const;
  double angle(double value) const;
  double slope(double angle) const;  ///< d value/d angle
};

}  // namespace pliant::calibrate
