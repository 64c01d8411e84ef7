#pragma once

#include "engine/case/case.hpp"

namespace pliant {

struct Box {
  Vector lower, upper;  ///< may be infinite
};

}  // namespace pliant
