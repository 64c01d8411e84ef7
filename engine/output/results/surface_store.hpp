#pragma once

#include <cstdint>
#include <vector>

#include "engine/output/hdf5/hdf5.hpp"
#include "engine/output/results/field_arrays.hpp"
#include "engine/output/results/frame.hpp"

namespace pliant {

/// The part of one frame's surface in the arrays of all frames.
struct SurfaceSpan {
  std::uint64_t first_vertex, vertices;
  std::uint64_t first_piece, pieces;
};

/// The surfaces of a run's frames, as the group /surface:
///
///     Points            [N][3]        vertices of all frames
///     PointData/<field> [N] or [N][component], attribute unit
///     Connectivity      [M][corner]   pieces of all frames; vertices of a frame count from 0
///     NumberOfPoints    [F]           of each frame
///     NumberOfCells     [F]
///
/// The surface of a frame is written before the frame itself, whose count makes both valid.
class SurfaceStore {
 public:
  /// Opens the surfaces in the file, if any. Throws hdf5::Failure, like all functions here.
  explicit SurfaceStore(hid_t file);

  /// Throws std::invalid_argument if the surface is inconsistent or differs in form from earlier
  /// ones.
  void append(const FrameSurface& surface, int real_bytes);
  void truncate(std::size_t frames);

  bool holds_any() const { return root_.valid(); }
  const std::vector<SurfaceSpan>& spans() const { return spans_; }  ///< [frame]
  StoredField position() const { return describe("Points", points_); }
  const std::vector<StoredField>& fields() const { return values_.fields(); }
  int corners() const { return connectivity_.components(); }

 private:
  void create(const FrameSurface& first, int real_bytes);
  void open();
  SurfaceSpan next() const;

  hid_t file_;
  hdf5::Handle root_;
  std::vector<SurfaceSpan> spans_;
  FieldArrays values_;
  hdf5::GrowingArray points_, connectivity_, vertices_, pieces_;
};

}  // namespace pliant
