#pragma once

/// Marks an HDF5 file as an archive.
namespace pliant::archive {

inline constexpr int format = 10;  ///< increased whenever the contents of checkpoints change
inline constexpr auto format_attribute = "pliant_archive_format";

}  // namespace pliant::archive
