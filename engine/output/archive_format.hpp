#pragma once

/// What tells an archive from any other HDF5 file.
namespace pliant::archive {

inline constexpr int format = 4;  ///< raised whenever checkpoints hold something else than before
inline constexpr auto format_attribute = "pliant_archive_format";

}  // namespace pliant::archive
