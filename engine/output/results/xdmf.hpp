#pragma once

#include <string>
#include <vector>

#include "engine/output/results/frame_store.hpp"
#include "engine/output/results/surface_store.hpp"

namespace pliant {

/// XDMF 3 text that shows the frames of an HDF5 file as a time series.
///
/// Its form is required by ParaView 5.11. Slabs are part of the path (with an item of type
/// HyperSlab, nothing is shown). The vertices have an explicit connectivity (without it they are
/// invisible). A symmetric tensor is a matrix with one row (XDMF expects another order of the six
/// components, ParaView the stored one).
class XdmfSeries {
 public:
  /// `grid` is the content of a frame: "particles" or "surface".
  XdmfSeries(const std::string& file_name, std::string grid);

  void add_particles(const FrameSpan& frame, const StoredField& position,
                     const std::vector<StoredField>& fields);
  /// Skips frames without any surface, which ParaView would report as errors.
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
