#pragma once

#include "engine/output/hdf5/hdf5.hpp"

namespace pliant::hdf5 {

/// A new file that changes by commits; its superblock has the format of version `oldest` of HDF5 or
/// a later one.
///
/// Each `flush` is a commit. If the process dies before, during or after one, the file can be
/// opened by any HDF5 reader and contains everything committed before; see commit_file.cpp. Readers
/// may open the file at any time, since it is not locked. Throws Failure, like all functions here.
Handle create_committed(const std::filesystem::path& path, H5F_libver_t oldest);

/// Opens such a file to continue it.
Handle open_committed(const std::filesystem::path& path);

/// Commits. Throws Failure if this or any write since the last commit failed. The file then stays
/// in the state of the last commit, whatever is done with it.
void flush(hid_t file);

/// Forces what has been committed onto the disk. Throws Failure.
void sync(hid_t file);

/// Keeps the file in the state of the last commit: later writes of HDF5, for example when it closes
/// the file, are ignored.
void abandon(hid_t file) noexcept;

}  // namespace pliant::hdf5
