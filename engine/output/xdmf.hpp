#pragma once

#include <string>
#include <vector>

#include "engine/output/frame_store.hpp"

namespace pliant {

/// The XDMF 3 text that shows the frames of an HDF5 file as a time series.
///
/// ParaView 5.11 decides its form: slabs are given within the path (an item of type HyperSlab shows
/// nothing), the vertices have an explicit connectivity (they are invisible without), and a
/// symmetric tensor is a matrix of one row (XDMF has another order of the six components in mind,
/// ParaView the one that is stored).
class XdmfSeries {
 public:
  explicit XdmfSeries(const std::string& file_name);

  void add(const FrameSpan& frame, const std::vector<StoredField>& fields);
  std::string text() const;

 private:
  std::string file_name_, frames_;
};

}  // namespace pliant
