#pragma once

#include <string>

#include "engine/case/case.hpp"

namespace pliant::point_based {

/// A warning where a cut advances by so few spacings that the opening beside it is off by more than
/// some percent; empty where there is none.
std::string resolution_warning(const Case& settings);

}  // namespace pliant::point_based
