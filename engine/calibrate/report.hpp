#pragma once

#include <string>

#include "engine/calibrate/fit.hpp"

namespace pliant::calibrate {

std::string text_of(const Fit& fit, const Calibration& found);
std::string json_of(const Fit& fit, const Calibration& found);

/// Data and fit for a plot: measurement, time, data, deviation, fit.
std::string curves_csv(const Fit& fit, const Calibration& found);

}  // namespace pliant::calibrate
