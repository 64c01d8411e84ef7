#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/output/hdf5/hdf5.hpp"
#include "engine/output/results/field_arrays.hpp"
#include "engine/output/results/frame.hpp"

namespace pliant {

/// The part of one frame in the arrays of all frames.
struct FrameSpan {
  double time;
  std::uint64_t first;
  std::uint64_t particles;
};

/// The frames of a run, as the group /VTKHDF: temporal PolyData in version 2.0 of that format, with
/// one part for each frame and one vertex for each particle.
///
/// Every array only grows at its end. If a process dies in `append`, all earlier frames are
/// unchanged, and NSteps, written last, still counts only them.
class FrameStore {
 public:
  /// Opens the frames in the file, if any. Throws hdf5::Failure, like all functions here.
  explicit FrameStore(hid_t file);

  /// Throws std::invalid_argument if the frame is inconsistent or differs in form from earlier
  /// ones.
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

  /// Particles of all frames: [particle]; `offset` has one more entry for each frame.
  hdf5::GrowingArray points_, offset_;
  /// 0, 1, 2, ... up to the largest frame: the vertices of a frame are its first points.
  hdf5::GrowingArray connectivity_;
  /// One entry for each frame.
  hdf5::GrowingArray time_, step_, particles_, part_, parts_, first_, cells_, connections_, none_;
};

}  // namespace pliant
