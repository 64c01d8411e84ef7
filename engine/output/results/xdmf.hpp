#pragma once

#include <string>
#include <vector>

#include "engine/output/results/frame_store.hpp"
#include "engine/output/results/surface_store.hpp"

namespace pliant {

/// The XDMF 3 text that shows the frames of an HDF5 file as a time series.
///
/// ParaView 5.11 decides its form: slabs are given within the path (an item of type HyperSlab shows
/// nothing), the vertices have an explicit connectivity (they are invisible without), and a
/// symmetric tensor is a matrix of one row (XDMF has another order of the six components in mind,
/// ParaView the one that is stored).
class XdmfSeries {
 public:
  /// `grid` is what a frame shows: "particles" or "surface".
  XdmfSeries(const std::string& file_name, std::string grid);

  void add_particles(const FrameSpan& frame, const StoredField& position,
                     const std::vector<StoredField>& fields);
  /// Leaves frames without any surface out, which ParaView would take for a fault.
  void add_surface(double time, const SurfaceSpan& span, int corners, const StoredField& position,
                   const std::vector<StoredField>& fields);
  std::string text() const;

 private:
  struct Rows {
    std::uint64_t first, count;
  };
  void add(double time, const std::string& topology, const std::string& root, const Rows& points,
           const StoredField& position, const std::vector<StoredField>& fields);
  static std::string slab(const std::string& path, const Rows& rows, const StoredField& field);

  std::string file_name_, grid_, frames_;
};

}  // namespace pliant
