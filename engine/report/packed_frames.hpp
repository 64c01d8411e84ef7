#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/report/run_reader.hpp"

namespace pliant::report {

/// What of a large run is left out so that its page stays small.
struct Thinning {
  int shift = 0;                ///< lowest bits of the 16 of a number that are left out
  std::size_t scalars = 0;      ///< the first so many are kept
  std::size_t every_frame = 1;  ///< and the last
  std::size_t every_particle = 1;
};

/// Points of one kind over all frames.
struct PackedSet {
  std::string kind;                                   ///< "surface" or "particles"
  int corners = 0;                                    ///< of a piece; 0: no pieces
  std::vector<std::size_t> points = {}, pieces = {};  ///< [frame]
  std::vector<bool> same = {};  ///< [frame] the pieces are those of the frame before
};

/// The frames of a run for a page: positions and numbers of 16 bits, between the least and the
/// largest of the run.
struct PackedFrames {
  Thinning thinning;
  std::vector<Scalar> scalars;
  std::vector<std::array<double, 2>> range;       ///< [scalar] least, largest
  std::array<double, 3> origin = {}, sides = {};  ///< of the box around all points [m]
  std::vector<double> times;                      ///< [frame] [s]
  std::vector<PackedSet> sets;
  std::vector<std::string> frames;  ///< base64, see byte_streams.hpp
};

/// Packs a run into at most `limit` bytes, if need be with fewer digits, numbers, frames and
/// particles, in this order.
PackedFrames pack(const RunReader& run, const std::vector<Scalar>& scalars, std::size_t limit);

}  // namespace pliant::report
