#include "engine/output/result_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "engine/output/atomic_file.hpp"
#include "engine/output/error.hpp"
#include "engine/output/frame_store.hpp"
#include "engine/output/hdf5.hpp"
#include "engine/output/history_store.hpp"
#include "engine/output/xdmf.hpp"

// Why a killed process leaves a readable file, without HDF5's SWMR mode (which leaves a mark in the
// file that makes every reader refuse it until h5clear is run):
//
//   - Metadata reaches the file in `flush` only, never because HDF5's cache is full.
//   - Chunks are indexed by extensible arrays (format of HDF5 1.10), which never move what they
//     hold. The index of format 1.8 is a B-tree whose nodes split in place.
//   - Every other structure is complete before the first frame is; later on arrays only grow, and a
//     chunk that two frames share is rewritten with the same bytes for the first.
//   - The superblock is that of the first format: later ones mark the file as open for writing.
//
// A test kills a writer at each of its writes.

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::Handle;

/// Besides the arrays a frame needs a few kilobytes of index.
constexpr std::uint64_t index_bytes = 256 * 1024;
/// Every array may need one more chunk than its values fill.
constexpr std::uint64_t chunk_rows = 16384;

Handle access() {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe access");
  checked(H5Pset_libver_bounds(properties, H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST),
          "choose the format");
  // A viewer may read the run while it is going on.
  checked(H5Pset_file_locking(properties, false, true), "leave the file unlocked");
  H5AC_cache_config_t cache;
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  checked(H5Pget_mdc_config(properties, &cache), "read the cache settings");
  cache.evictions_enabled = false;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  checked(H5Pset_mdc_config(properties, &cache), "keep metadata in memory");
  return properties;
}

Handle create_file(const std::filesystem::path& path) {
  const auto properties = hdf5::creation_of(H5P_FILE_CREATE);
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties, access()), H5Fclose, "create it");
  checked(H5Fset_libver_bounds(file, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the format");
  return file;
}

Handle open_file(const std::filesystem::path& path) {
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access()), H5Fclose, "open it");
  checked(H5Fset_libver_bounds(file, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the format");
  return file;
}

/// Keeps a second run out of a folder, by a lock that ends with the process.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw OutputError::system(folder, "open this folder", errno);
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(descriptor_);
    throw OutputError(folder, "another run is writing into this folder",
                      "wait for it, or choose another folder with --out");
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() { ::close(descriptor_); }

 private:
  int descriptor_;
};

void describe(hid_t file, const RunDescription& run) {
  const auto group = hdf5::create_group(file, "run");
  hdf5::write_attribute(group, "case", run.case_name);
  hdf5::write_attribute(group, "title", run.title);
  hdf5::write_attribute(group, "method", run.method);
  hdf5::write_attribute(group, "version", run.version);
  hdf5::write_attribute(group, "dimension", run.dimension);
  hdf5::write_text(group, "case.toml", run.resolved_case);
}

std::uint64_t bytes_of(const Frame& frame) {
  std::uint64_t row = 5 * sizeof(double);  // position, offset, connectivity
  for (const auto& field : frame.fields)
    row += static_cast<std::uint64_t>(field.components + 1) * sizeof(double);
  return row * (frame.position.size() / 3 + chunk_rows);
}

}  // namespace

struct ResultFile::File {
  FolderLock lock;
  std::filesystem::path path, viewer;
  bool named;  ///< has its final name, not the temporary one
  bool failed = false;
  Handle file;
  FrameStore frames;
  HistoryStore histories;

  File(const std::filesystem::path& folder, bool existing)
      : lock(folder),
        path(folder / "result.h5"),
        viewer(folder / "result.xdmf"),
        named(existing),
        file(existing ? open_file(path) : create_file(temporary_name(path))),
        frames(file),
        histories(file) {}

  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    std::error_code ignored;
    if (!named) std::filesystem::remove(temporary_name(path), ignored);
  }

  void require_open() const {
    if (!file.valid() || failed)
      throw std::logic_error(path.string() + ": written to after it was closed");
  }

  /// Takes the space for `bytes` more before anything is changed, so that a full disk is found
  /// while the file is whole. File systems that cannot are believed to have room.
  void reserve(std::uint64_t bytes) const {
    const int descriptor = hdf5::descriptor(file);
    const auto end = ::lseek(descriptor, 0, SEEK_END);
    const auto size = static_cast<off_t>(bytes + index_bytes);
    if (::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, end, size) == 0) return;
    if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)
      throw OutputError::system(path, "write the next frame", errno);
  }

  /// Runs `change`; when it fails, what it left half done never reaches the disk.
  template <class Change>
  void guarded(Change change) {
    require_open();
    hdf5::silence();
    try {
      change();
    } catch (const hdf5::Failure& failure) {
      failed = true;
      hdf5::abandon(file);
      throw failure.on(path);
    }
  }

  void write_viewer() const {
    write_atomically(viewer, xdmf_of(path.filename().string(), frames.frames(), frames.fields()));
  }
};

ResultFile::ResultFile(std::unique_ptr<File> file) : file_(std::move(file)) {}
ResultFile::ResultFile(ResultFile&&) noexcept = default;
ResultFile& ResultFile::operator=(ResultFile&&) noexcept = default;

ResultFile ResultFile::create(const std::filesystem::path& folder, const RunDescription& run) {
  const auto path = folder / "result.h5";
  hdf5::silence();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError::system(folder, "create this folder", error.value());
  try {
    auto file = std::make_unique<File>(folder, false);
    file->guarded([&] { describe(file->file, run); });
    return ResultFile(std::move(file));
  } catch (const hdf5::Failure& failure) {
    throw failure.on(path);
  }
}

ResultFile ResultFile::resume(const std::filesystem::path& folder, const ResultExtent& extent) {
  const auto path = folder / "result.h5";
  hdf5::silence();
  try {
    auto file = std::make_unique<File>(folder, true);
    const auto rows = file->histories.rows();
    auto complete = static_cast<std::int64_t>(file->frames.frames().size()) >= extent.frames;
    for (const auto& [name, count] : extent.history_rows)
      complete = complete && (count == 0 || (rows.contains(name) && rows.at(name) >= count));
    if (!complete)
      throw OutputError(path, "holds less than the checkpoint remembers",
                        "put back the file that belongs to the checkpoint, or run anew");
    file->guarded([&] {
      file->frames.truncate(static_cast<std::size_t>(extent.frames));
      file->histories.truncate(extent.history_rows);
      hdf5::flush(file->file);
    });
    file->write_viewer();
    return ResultFile(std::move(file));
  } catch (const hdf5::Failure& failure) {
    throw failure.on(path);
  }
}

ResultFile::~ResultFile() {
  if (!file_ || !file_->file.valid()) return;
  try {
    close();
  } catch (const std::exception&) {
  }
}

void ResultFile::append(const Frame& frame) {
  auto& file = *file_;
  file.require_open();
  file.reserve(bytes_of(frame) + file.histories.bytes_held_back());
  file.guarded([&] {
    file.histories.flush();
    file.frames.append(frame);
  });
  if (!file.named) {
    std::error_code ignored;
    std::filesystem::remove(file.viewer, ignored);  // an earlier run's, whose frames go now
    publish(temporary_name(file.path), file.path);
    file.named = true;
  }
  file.write_viewer();
}

void ResultFile::append_history(const std::string& name, const std::string& unit, double time,
                                double value) {
  file_->require_open();
  file_->histories.append(name, unit, time, value);
}

ResultExtent ResultFile::flush() {
  auto& file = *file_;
  file.require_open();
  file.reserve(file.histories.bytes_held_back());
  file.guarded([&] {
    file.histories.flush();
    hdf5::flush(file.file);
  });
  if (::fsync(hdf5::descriptor(file.file)) != 0)
    throw OutputError::system(file.path, "write it to the disk", errno);
  return {static_cast<std::int64_t>(file.frames.frames().size()), file.histories.rows()};
}

void ResultFile::close() {
  if (!file_) return;
  const auto file = std::move(file_);
  if (file->failed) return;
  file->reserve(file->histories.bytes_held_back());
  file->guarded([&] {
    file->histories.flush();
    hdf5::flush(file->file);
  });
  // Space that was reserved and not needed goes back.
  const int descriptor = hdf5::descriptor(file->file);
  const auto size = ::lseek(descriptor, 0, SEEK_END);
  if (::ftruncate(descriptor, size) != 0)
    throw OutputError::system(file->path, "shorten it", errno);
}

}  // namespace pliant
