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

/// Bytes that HDF5 has written to a file, and the kind of their block.
struct Write {
  H5FD_mem_t kind;
  haddr_t begin;
  std::string bytes;

  haddr_t end() const { return begin + bytes.size(); }
};

/// A file whose blocks are held back until a commit. HDF5 identifies the files of a driver by a
/// pointer to this struct, whose first member belongs to HDF5.
struct CommitFile {
  H5FD_t base = {};
  int descriptor = -1;
  haddr_t end = 0;             ///< as allocated by HDF5
  haddr_t committed_end = 0;   ///< as in the superblock of the file
  haddr_t size = 0;            ///< of the file
  bool has_committed = false;  ///< since it was opened
  bool abandoned = false;
  int error_number = 0;  ///< of the first call that failed; the file is then abandoned
  std::vector<Write> held_back;

  // A function that returns false has failed and set `errno`.

  /// Writes at once.
  bool write(haddr_t begin, const void* bytes, std::size_t count);
  /// Reads what has been written or held back; zeros elsewhere.
  bool read(haddr_t begin, void* bytes, std::size_t count) const;
  /// Writes what has been held back, in the order of commit_file.cpp.
  bool commit();
  /// Abandons the file unless `done`, and stores the error.
  void note(bool done);

 private:
  bool grow();
};

}  // namespace pliant::hdf5
