#pragma once

#include <string>
#include <vector>

#include "engine/output/frame_store.hpp"

namespace pliant {

/// The XDMF 3 text that shows frames of the HDF5 file `file_name` as a time series.
///
/// ParaView 5.11 decides its form: slabs are given within the path (an item of type HyperSlab shows
/// nothing), and the vertices have an explicit connectivity (they are invisible without).
std::string xdmf_of(const std::string& file_name, const std::vector<FrameSpan>& frames,
                    const std::vector<StoredField>& fields);

}  // namespace pliant
