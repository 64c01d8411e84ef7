#pragma once

#include <H5public.h>
#if H5_VERSION_GE(1, 14, 0)
#include <H5FDdevelop.h>  // where later versions declare what drivers are made of
#elif H5_VERSION_GE(1, 13, 0)
#error "HDF5 1.13 has development releases only: build with 1.10, 1.12 or 1.14"
#endif
#include <hdf5.h>

#include <string>
#include <vector>

namespace pliant::hdf5 {

/// Bytes that HDF5 has written into a file, and what they are part of.
struct Write {
  H5FD_mem_t kind;
  haddr_t begin;
  std::string bytes;

  haddr_t end() const { return begin + bytes.size(); }
};

/// A file whose blocks are held back until they are committed. HDF5 knows files of a driver by a
/// pointer to this, whose first member is its own.
struct CommitFile {
  H5FD_t base = {};
  int descriptor = -1;
  haddr_t end = 0;             ///< as HDF5 has allocated
  haddr_t committed_end = 0;   ///< as the superblock in the file states
  haddr_t size = 0;            ///< of the file
  bool has_committed = false;  ///< since it was opened
  bool abandoned = false;
  int error_number = 0;  ///< of the first call that failed; the file is abandoned then
  std::vector<Write> held_back;

  // Those that return false have failed, and `errno` says why.

  /// Writes at once.
  bool write(haddr_t begin, const void* bytes, std::size_t count);
  /// Reads what has been written and what is held back; zeros where nothing is.
  bool read(haddr_t begin, void* bytes, std::size_t count) const;
  /// Writes what is held back, in the order of commit_file.cpp.
  bool commit();
  /// Abandons the file unless `done`, and keeps the error.
  void note(bool done);

 private:
  bool grow();
};

}  // namespace pliant::hdf5
