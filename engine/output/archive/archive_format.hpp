#pragma once

/// How an archive is recognised among HDF5 files.
namespace pliant::archive {

inline constexpr int format = 7;  ///< raised whenever checkpoints hold something else than before
inline constexpr auto format_attribute = "pliant_archive_format";

}  // namespace pliant::archive
