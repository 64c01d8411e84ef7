#include "engine/output/hdf5/commit_driver.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string>

#include "engine/output/hdf5/commit_file.hpp"

// A file driver for HDF5: the layer through which HDF5 reads and writes a file. HDF5 calls its
// functions; commit_file.cpp explains their effect on the file.

namespace pliant::hdf5 {
namespace {

CommitFile& of(H5FD_t* file) { return *reinterpret_cast<CommitFile*>(file); }
const CommitFile& of(const H5FD_t* file) { return *reinterpret_cast<const CommitFile*>(file); }

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
  // If HDF5 refused to open a file, it has set no end.
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

/// Does nothing: the file is cut when it is closed; before, its superblock may still have a later
/// end.
herr_t truncate_file(H5FD_t*, hid_t, hbool_t) { return 0; }

hid_t driver() {
  static const hid_t registered = [] {
    H5FD_class_t functions = {};
#if H5_VERSION_GE(1, 14, 0)
    static_assert(H5FD_CLASS_VERSION == 1,
                  "this version of HDF5 describes drivers in a new way: compare the members of its "
                  "H5FD_class_t with those that are set here");
    functions.version = H5FD_CLASS_VERSION;
    functions.value = 300;  // from the range for private drivers
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

void abandon(hid_t file) noexcept {
  void* handle = nullptr;
  if (H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0) return;
  static_cast<CommitFile*>(handle)->abandoned = true;
}

}  // namespace pliant::hdf5
