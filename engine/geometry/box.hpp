#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

struct Box {
  Vector lower, upper;  ///< may be infinite
};

}  // namespace pliant
