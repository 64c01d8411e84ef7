#pragma once

#include "engine/output/hdf5.hpp"

namespace pliant::hdf5 {

/// How to open a file that changes by commits, in formats no older than `oldest` and no newer than
/// `latest`.
///
/// Each `flush` is a commit. A process that dies before, within or after one leaves a file that any
/// HDF5 reader opens and that has all that was committed before; see commit_driver.cpp. Readers may
/// open the file at any time, since it is not locked.
Handle commit_access(H5F_libver_t oldest, H5F_libver_t latest);

/// Commits. Throws Failure when this or any write since the last commit failed; the file stays as
/// the last commit left it then, whatever is done with it.
void flush(hid_t file);

/// Forces what was committed onto the disk. Throws Failure.
void sync(hid_t file);

/// Leaves the file as the last commit left it: whatever HDF5 still writes, as when it closes the
/// file, is dropped.
void abandon(hid_t file);

}  // namespace pliant::hdf5
