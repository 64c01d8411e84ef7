#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pliant {

/// One quantity on every particle of a frame.
struct FrameField {
  std::string name;  ///< without '/' and '.', which are special in HDF5
  std::string unit;  ///< SI, "1" for a pure number
  /// 1: scalar; 2 or 3: vector (two components are stored as three, the third zero); 6: symmetric
  /// tensor as xx, yy, zz, xy, yz, xz.
  int components = 1;
  /// [particle][component]
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>> values;
};

/// The surfaces of all bodies at one time: segments in 2D, triangles in 3D.
struct FrameSurface {
  int corners = 3;                   ///< of a piece: 2 or 3
  std::vector<double> position;      ///< [vertex][3] [m]
  std::vector<std::int64_t> vertex;  ///< [piece][corner]
  std::vector<FrameField> fields;    ///< on the vertices
};

/// What a frame contains besides the particles.
struct FrameParts {
  bool ghosts = false;
  bool surface = false;  ///< the closed surface of every body
};

/// The particles at one time. Every frame of a run has the same fields; the number of particles may
/// change.
struct Frame {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::vector<double> position;  ///< [particle][3], at least one particle [m]
  std::vector<FrameField> fields;
  int real_bytes = sizeof(double);      ///< of a stored number: 8, or 4 in single precision
  std::optional<FrameSurface> surface;  ///< in all frames of a run, or in none
};

}  // namespace pliant
