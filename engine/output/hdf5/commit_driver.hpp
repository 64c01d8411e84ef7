#pragma once

#include "engine/output/hdf5/hdf5.hpp"

namespace pliant::hdf5 {

/// A new file that changes by commits, its superblock in the format of version `oldest` of HDF5 or
/// a later one.
///
/// Each `flush` is a commit. A process that dies before, within or after one leaves a file that any
/// HDF5 reader opens and that has all that was committed before; see commit_file.cpp. Readers may
/// open the file at any time, since it is not locked. Throws Failure, as all here do.
Handle create_committed(const std::filesystem::path& path, H5F_libver_t oldest);

/// Opens such a file to continue it.
Handle open_committed(const std::filesystem::path& path);

/// Commits. Throws Failure when this or any write since the last commit failed; the file stays as
/// the last commit left it then, whatever is done with it.
void flush(hid_t file);

/// Forces what was committed onto the disk. Throws Failure.
void sync(hid_t file);

/// Leaves the file as the last commit left it: whatever HDF5 still writes, as when it closes the
/// file, is dropped.
void abandon(hid_t file);

}  // namespace pliant::hdf5
