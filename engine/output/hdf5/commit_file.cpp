#include "engine/output/hdf5/commit_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

// A file of the commit driver: what is behind the layer through which HDF5 reads and writes it.
//
// HDF5 writes the blocks that describe a file (object headers, chunk indices, the superblock with
// the end of the file) in order of their addresses, whenever its cache is full or the file is
// flushed. A process that dies in between leaves, for example, an index that points to a block
// which was never written, or blocks beyond the end given in the superblock. HDF5's own solution,
// SWMR, leaves a mark in the file of a killed writer that makes readers refuse it.
//
// Here such blocks are held back until the flush. Then they are written such that the file is valid
// after every single write:
//
//      0                       committed end               end
//      | superblock | blocks, values | new blocks, new values |
//
//   values           at once: nothing refers to them yet beyond the committed end; in a chunk
//                    that began before, the older values are written again unchanged
//   1. file size     grows to the end, and the space is allocated: a full disk is detected here
//   2. new blocks    nothing refers to them yet
//   3. superblock    contains the new end, which exists
//   4. old blocks    now refer to new ones, which exist
//
// When the file shrinks, 3 and 4 are swapped: old blocks first drop what is beyond the new end. The
// order within 4 must not matter. It does not if arrays only grow and are indexed by extensible
// arrays, which never move an entry: a reader finds the new length with or without the new chunks,
// and missing chunks read as zeros. It would for the B-trees of older formats, whose nodes split.
// Freed space must not be reused, since a new block there would count as old; a reopened file does
// not reuse it.

namespace pliant::hdf5 {

bool CommitFile::write(haddr_t begin, const void* bytes, std::size_t count) {
  const auto* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const auto written = ::pwrite(descriptor, next, count, static_cast<off_t>(begin));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    next += written;
    begin += static_cast<haddr_t>(written);
    count -= static_cast<std::size_t>(written);
  }
  size = std::max(size, begin);
  return true;
}

bool CommitFile::read(haddr_t begin, void* bytes, std::size_t count) const {
  auto* const target = static_cast<char*>(bytes);
  std::size_t done = 0;
  while (done < count) {
    const auto found =
        ::pread(descriptor, target + done, count - done, static_cast<off_t>(begin + done));
    if (found < 0 && errno == EINTR) continue;
    if (found < 0) return false;
    if (found == 0) break;
    done += static_cast<std::size_t>(found);
  }
  std::memset(target + done, 0, count - done);  // allocated but not written yet
  for (const auto& write : held_back) {
    const auto from = std::max(begin, write.begin), to = std::min(begin + count, write.end());
    if (from < to)
      std::memcpy(target + (from - begin), write.bytes.data() + (from - write.begin), to - from);
  }
  return true;
}

bool CommitFile::grow() {
  const auto begin = std::min(size, committed_end);
  if (end <= begin) return true;
  if (::fallocate(descriptor, 0, static_cast<off_t>(begin), static_cast<off_t>(end - begin)) != 0) {
    const bool unsupported = errno == EOPNOTSUPP || errno == ENOSYS || errno == EINVAL;
    if (!unsupported) return false;
    if (size < end && ::ftruncate(descriptor, static_cast<off_t>(end)) != 0) return false;
  }
  size = std::max(size, end);
  return true;
}

bool CommitFile::commit() {
  if (abandoned || held_back.empty()) return true;
  const auto order = [&](const Write& write) {
    if (write.kind == H5FD_MEM_SUPER) return end < committed_end ? 3 : 1;
    return write.begin >= committed_end ? 0 : 2;
  };
  std::ranges::stable_sort(held_back, {}, order);
  if (!grow()) return false;
  for (const auto& block : held_back)
    if (!write(block.begin, block.bytes.data(), block.bytes.size())) return false;
  held_back.clear();
  committed_end = end;
  has_committed = true;
  return true;
}

/// HDF5 is not told that a write failed: it would keep the data, try again when it closes the file,
/// and fail again at the end of the process. `flush` reports the error instead.
void CommitFile::note(bool done) {
  if (done || abandoned) return;
  error_number = errno;
  abandoned = true;
}

}  // namespace pliant::hdf5
