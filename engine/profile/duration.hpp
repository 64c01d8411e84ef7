#pragma once

#include <string>

namespace pliant::profile {

/// Seconds of a positive duration with its unit: "16.7ms", "800 us", "0.5s", "2min". Throws
/// InputError that begins with `option`.
double seconds_of(const std::string& text, const std::string& option);

}  // namespace pliant::profile
