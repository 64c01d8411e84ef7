#include "engine/output/commit_driver.hpp"

#include <H5public.h>
#include <fcntl.h>
#if H5_VERSION_GE(1, 14, 0)
#include <H5FDdevelop.h>  // where later versions declare what drivers are made of
#elif H5_VERSION_GE(1, 13, 0)
#error "HDF5 1.13 has development releases only: build with 1.10, 1.12 or 1.14"
#endif
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

// A file driver for HDF5: the layer that HDF5 reads and writes a file through.
//
// HDF5 writes the blocks that describe a file (object headers, chunk indices, the superblock with
// the file's end) in order of their address, whenever its cache is full or the file is flushed. A
// process that dies among them leaves, say, an index that points to a block which was never
// written, or blocks beyond the end that the superblock states. HDF5's own answer, SWMR, leaves a
// mark in a killed writer's file that makes readers refuse it.
//
// Here such blocks are held back until the flush, and then written so that the file is whole after
// every single write:
//
//      0                       committed end               end
//      | superblock | blocks, values | new blocks, new values |
//
//   values           at once: beyond the committed end nothing refers to them yet, and in a chunk
//                    that began before, the older values are written again as they were
//   1. file size     grows to the end, and the space is taken: a full disk is found here
//   2. new blocks    nothing refers to them yet
//   3. superblock    states the new end, which is there
//   4. old blocks    now refer to new ones, which are there
//
// When the file shrinks, 3 and 4 change places: old blocks first drop what lies beyond the new end.
// The order within 4 must not matter. It does not where arrays only grow and are indexed by
// extensible arrays, which never move an entry: a reader finds the new length with or without the
// new chunks, and missing chunks read as zeros. It would for the B-trees of older formats, whose
// nodes split. Space that was freed must not be used again, since a new block there would count as
// old; a file that is opened anew does not use such space.

namespace pliant::hdf5 {
namespace {

struct Write {
  H5FD_mem_t kind;
  haddr_t begin;
  std::string bytes;

  haddr_t end() const { return begin + bytes.size(); }
};

/// HDF5 knows files of a driver by a pointer to this, whose first member is its own.
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

  bool write(haddr_t begin, const void* bytes, std::size_t count);
  bool read(haddr_t begin, void* bytes, std::size_t count) const;
  bool grow();
  bool commit();
  void note(bool done);
};

CommitFile& of(H5FD_t* file) { return *reinterpret_cast<CommitFile*>(file); }
const CommitFile& of(const H5FD_t* file) { return *reinterpret_cast<const CommitFile*>(file); }

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
  std::memset(target + done, 0, count - done);  // allocated, not written yet
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

/// HDF5 does not learn that a write failed: it would keep what it could not write, try again when
/// it closes the file, and fail again at the end of the process. `flush` reports the error instead.
void CommitFile::note(bool done) {
  if (done || abandoned) return;
  error_number = errno;
  abandoned = true;
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t, haddr_t) {
  int mode = (flags & H5F_ACC_RDWR) ? O_RDWR : O_RDONLY;
  if (flags & H5F_ACC_TRUNC) mode |= O_TRUNC;
  if (flags & H5F_ACC_CREAT) mode |= O_CREAT;
  if (flags & H5F_ACC_EXCL) mode |= O_EXCL;
  auto file = std::make_unique<CommitFile>();
  file->descriptor = ::open(name, mode | O_CLOEXEC, 0666);
  struct stat about = {};
  if (file->descriptor < 0 || ::fstat(file->descriptor, &about) != 0) {
    H5Epush2(H5E_DEFAULT, __FILE__, "open_file", __LINE__, H5E_ERR_CLS, H5E_VFL, H5E_CANTOPENFILE,
             "errno = %d", errno);
    return nullptr;
  }
  file->size = static_cast<haddr_t>(about.st_size);
  return &file.release()->base;
}

herr_t close_file(H5FD_t* base) {
  const std::unique_ptr<CommitFile> file(&of(base));
  file->note(file->commit());
  // A file that HDF5 refused to open has no end that HDF5 knows of.
  if (file->has_committed && !file->abandoned && file->size > file->end)
    file->note(::ftruncate(file->descriptor, static_cast<off_t>(file->end)) == 0);
  ::close(file->descriptor);
  return 0;
}

int compare_files(const H5FD_t* a, const H5FD_t* b) {
  struct stat of_a = {}, of_b = {};
  ::fstat(of(a).descriptor, &of_a);
  ::fstat(of(b).descriptor, &of_b);
  const auto key = [](const auto& about) { return std::pair(about.st_dev, about.st_ino); };
  return key(of_a) < key(of_b) ? -1 : key(of_b) < key(of_a) ? 1 : 0;
}

herr_t tell_features(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_end(const H5FD_t* file, H5FD_mem_t) { return of(file).end; }

herr_t set_end(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  of(file).end = end;
  return 0;
}

haddr_t get_size(const H5FD_t* file, H5FD_mem_t) { return of(file).size; }

herr_t get_handle(H5FD_t* file, hid_t, void** handle) {
  *handle = &of(file);
  return 0;
}

herr_t read_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t begin, std::size_t count, void* bytes) {
  return of(file).read(begin, bytes, count) ? 0 : -1;
}

herr_t write_file(H5FD_t* base, H5FD_mem_t kind, hid_t, haddr_t begin, std::size_t count,
                  const void* bytes) {
  auto& file = of(base);
  if (file.abandoned) return 0;
  if (kind == H5FD_MEM_DRAW)
    file.note(file.write(begin, bytes, count));
  else
    file.held_back.push_back({kind, begin, std::string(static_cast<const char*>(bytes), count)});
  return 0;
}

herr_t flush_file(H5FD_t* file, hid_t, hbool_t) {
  of(file).note(of(file).commit());
  return 0;
}

/// The file is cut when it is closed; before, the superblock in it may still tell a later end.
herr_t truncate_file(H5FD_t*, hid_t, hbool_t) { return 0; }

hid_t driver() {
  static const hid_t registered = [] {
    H5FD_class_t functions = {};
#if H5_VERSION_GE(1, 14, 0)
    static_assert(H5FD_CLASS_VERSION == 1,
                  "this version of HDF5 describes drivers in a new way: compare the members of its "
                  "H5FD_class_t with those that are set here");
    functions.version = H5FD_CLASS_VERSION;
    functions.value = 300;  // of the range that is free for private drivers
#endif
    functions.name = "commit";
    functions.maxaddr = haddr_t{1} << 62;
    functions.fc_degree = H5F_CLOSE_WEAK;
    functions.open = open_file;
    functions.close = close_file;
    functions.cmp = compare_files;
    functions.query = tell_features;
    functions.get_eoa = get_end;
    functions.set_eoa = set_end;
    functions.get_eof = get_size;
    functions.get_handle = get_handle;
    functions.read = read_file;
    functions.write = write_file;
    functions.flush = flush_file;
    functions.truncate = truncate_file;
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::ranges::copy(map, functions.fl_map);
    return checked(H5FDregister(&functions), "register the commit driver");
  }();
  return registered;
}

CommitFile& commit_file(hid_t file) {
  void* handle = nullptr;
  checked(H5Fget_vfd_handle(file, H5P_DEFAULT, &handle), "find the open file");
  return *static_cast<CommitFile*>(handle);
}

Handle access(H5F_libver_t oldest) {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe access");
  checked(H5Pset_driver(properties, driver(), nullptr), "choose the driver");
  checked(H5Pset_libver_bounds(properties, oldest, H5F_LIBVER_LATEST), "choose the format");
  return properties;
}

}  // namespace

Handle create_committed(const std::filesystem::path& path, H5F_libver_t oldest) {
  const auto properties = creation_of(H5P_FILE_CREATE);
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties, access(oldest)), H5Fclose,
          "create it"};
}

Handle open_committed(const std::filesystem::path& path) {
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access(H5F_LIBVER_EARLIEST)), H5Fclose,
              "open it");
  auto& opened = commit_file(file);
  opened.committed_end = opened.end;
  return file;
}

void flush(hid_t file) {
  checked(H5Fflush(file, H5F_SCOPE_LOCAL), "write it");
  if (const int number = commit_file(file).error_number; number != 0)
    throw Failure::system("write it", number);
}

void sync(hid_t file) {
  if (::fsync(commit_file(file).descriptor) != 0)
    throw Failure::system("write it to the disk", errno);
}

void abandon(hid_t file) { commit_file(file).abandoned = true; }

}  // namespace pliant::hdf5
