#pragma once

/// What tells an archive from any other HDF5 file.
namespace pliant::archive {

inline constexpr int format = 2;  ///< raised when an older program could no longer read the file
inline constexpr auto format_attribute = "pliant_archive_format";

}  // namespace pliant::archive
