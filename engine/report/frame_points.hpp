#pragma once

#include <cstdint>
#include <vector>

namespace pliant::report {

/// Points of one frame, with scalars.
struct FramePoints {
  std::vector<float> position;             ///< [point][3] [m]
  std::vector<std::vector<float>> values;  ///< [scalar][point]
  std::vector<std::uint32_t> vertex;       ///< [piece][corner]; only for surfaces

  std::size_t count() const { return position.size() / 3; }
};

}  // namespace pliant::report
