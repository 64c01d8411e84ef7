#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/output/hdf5/hdf5.hpp"
#include "engine/output/results/field_arrays.hpp"
#include "engine/output/results/frame.hpp"

namespace pliant {

/// Where one frame lies in the arrays of all frames.
struct FrameSpan {
  double time;
  std::uint64_t first;
  std::uint64_t particles;
};

/// The frames of a run, as the group /VTKHDF: temporal PolyData of version 2.0 of that format, one
/// part a frame, one vertex a particle.
///
/// Every array grows at its end only. A process that dies in `append` leaves all earlier frames as
/// they were, and NSteps, written last, still counts them.
class FrameStore {
 public:
  /// Opens the frames that the file holds, if any. Throws hdf5::Failure, as all here do.
  explicit FrameStore(hid_t file);

  /// Throws std::invalid_argument when the frame contradicts itself or the earlier ones.
  void append(const Frame& frame);
  void truncate(std::size_t frames);

  const std::vector<FrameSpan>& frames() const { return frames_; }
  StoredField position() const { return describe("Points", points_); }
  const std::vector<StoredField>& fields() const { return values_.fields(); }

 private:
  void create(const Frame& first);
  void open();
  void append_particles(const Frame& frame);
  void append_step(const Frame& frame);

  hid_t file_;
  hdf5::Handle root_, steps_;
  std::vector<FrameSpan> frames_;
  FieldArrays values_;

  /// Particles of all frames: [particle]; `offset` has one more entry a frame.
  hdf5::GrowingArray points_, offset_;
  /// 0, 1, 2, ... as far as the largest frame needs: every frame's vertices are its first points.
  hdf5::GrowingArray connectivity_;
  /// One entry a frame.
  hdf5::GrowingArray time_, step_, particles_, part_, parts_, first_, cells_, connections_, none_;
};

}  // namespace pliant
