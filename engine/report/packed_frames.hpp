#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/report/run_reader.hpp"

namespace pliant::report {

/// What is left out of a large run to limit its page.
struct Thinning {
  int shift = 0;                ///< lowest bits, of the 16 of a number, that are left out
  std::size_t scalars = 0;      ///< number of scalars that are kept, from the first on
  std::size_t every_frame = 1;  ///< and the last one
  std::size_t every_particle = 1;
};

/// Points of one kind over all frames.
struct PackedSet {
  std::string kind;                                   ///< "surface" or "particles"
  int corners = 0;                                    ///< of a piece; 0: no pieces
  std::vector<std::size_t> points = {}, pieces = {};  ///< [frame]
  std::vector<bool> same = {};  ///< [frame] whether the pieces equal those of the frame before
};

/// The frames of a run for a page: positions and scalars with 16 bits between the extremes of the
/// run.
struct PackedFrames {
  Thinning thinning;
  std::vector<Scalar> scalars;
  std::vector<std::array<double, 2>> range;       ///< [scalar] smallest, largest
  std::array<double, 3> origin = {}, sides = {};  ///< of the box around all points [m]
  std::vector<double> times;                      ///< [frame] [s]
  std::vector<PackedSet> sets;
  std::vector<std::string> frames;  ///< base64, see byte_streams.hpp
};

/// Packs a run into at most `limit` bytes; if necessary with fewer digits, scalars, frames and
/// particles, in this order.
PackedFrames pack(const RunReader& run, const std::vector<Scalar>& scalars, std::size_t limit);

}  // namespace pliant::report
