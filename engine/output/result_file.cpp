#include "engine/output/result_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "engine/output/atomic_file.hpp"
#include "engine/output/commit_driver.hpp"
#include "engine/output/error.hpp"
#include "engine/output/frame_store.hpp"
#include "engine/output/hdf5.hpp"
#include "engine/output/history_store.hpp"
#include "engine/output/surface_store.hpp"
#include "engine/output/xdmf.hpp"

// Why a killed process leaves a readable file: it changes by commits (see commit_driver.cpp), which
// ask that arrays only grow and are indexed by extensible arrays. Those came with the format of
// HDF5 1.10, whose superblock also marks a file as open for writing, so that readers refuse what a
// killed process leaves; hence the superblock is of the first format, and all else of the later.

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::Handle;

Handle with_extensible_arrays(Handle file) {
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

}  // namespace

struct ResultFile::File {
  FolderLock lock;
  std::filesystem::path path, viewer, surface_viewer;
  std::optional<TemporaryFile> temporary;  ///< of a new file, until its first frame is whole
  bool failed = false;
  Handle file;
  FrameStore frames;
  SurfaceStore surfaces;
  HistoryStore histories;
  XdmfSeries series{"result.h5", "particles"}, surface_series{"result.h5", "surface"};
  std::size_t shown = 0;  ///< frames in `series`

  File(const std::filesystem::path& folder, bool existing)
      : lock(folder),
        path(folder / "result.h5"),
        viewer(folder / "result.xdmf"),
        surface_viewer(folder / "surface.xdmf"),
        temporary(existing ? std::nullopt : std::make_optional<TemporaryFile>(path)),
        file(with_extensible_arrays(
            existing ? hdf5::open_committed(path)
                     : hdf5::create_committed(temporary->path(), H5F_LIBVER_EARLIEST))),
        frames(file),
        surfaces(file),
        histories(file) {}

  /// Runs `change`; when it fails, the file stays as the last commit left it.
  template <class Change>
  void guarded(Change change) {
    hdf5::silence();
    try {
      change();
    } catch (const hdf5::Failure& failure) {
      failed = true;
      hdf5::abandon(file);
      throw failure.on(path);
    }
  }

  void write_viewer() {
    for (; shown < frames.frames().size(); ++shown) {
      const FrameSpan& frame = frames.frames()[shown];
      series.add_particles(frame, frames.position(), frames.fields());
      if (surfaces.holds_any())
        surface_series.add_surface(frame.time, surfaces.spans()[shown], surfaces.corners(),
                                   surfaces.position(), surfaces.fields());
    }
    write_atomically(viewer, series.text(), Durable::no);
    if (surfaces.holds_any()) write_atomically(surface_viewer, surface_series.text(), Durable::no);
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
    cut(folder, extent);
    // Opened anew, the file forgets the space that this freed, as commits ask for.
    auto file = std::make_unique<File>(folder, true);
    file->write_viewer();
    return ResultFile(std::move(file));
  } catch (const hdf5::Failure& failure) {
    throw failure.on(path);
  }
}

void ResultFile::cut(const std::filesystem::path& folder, const ResultExtent& extent) {
  File file(folder, true);
  const auto rows = file.histories.rows();
  auto complete = static_cast<std::int64_t>(file.frames.frames().size()) >= extent.frames;
  for (const auto& [name, count] : extent.history_rows)
    complete = complete && (count == 0 || (rows.contains(name) && rows.at(name) >= count));
  if (!complete)
    throw OutputError(file.path, "holds less than the checkpoint remembers",
                      "put back the file that belongs to the checkpoint, or run anew");
  file.guarded([&] {
    file.frames.truncate(static_cast<std::size_t>(extent.frames));
    file.surfaces.truncate(static_cast<std::size_t>(extent.frames));
    file.histories.truncate(extent.history_rows);
    hdf5::flush(file.file);
  });
}

ResultFile::File& ResultFile::open_file() const {
  if (!file_ || file_->failed)
    throw std::logic_error("a result file was written to after it was closed or had failed");
  return *file_;
}

ResultFile::~ResultFile() {
  try {
    close();
  } catch (const std::exception&) {
  }
}

void ResultFile::append(const Frame& frame) {
  auto& file = open_file();
  file.guarded([&] {
    file.histories.flush();
    if (frame.surface) file.surfaces.append(*frame.surface, frame.real_bytes);
    file.frames.append(frame);
  });
  if (file.temporary) {
    std::error_code ignored;
    // An earlier run's, whose frames go now.
    for (const auto& shown : {file.viewer, file.surface_viewer})
      std::filesystem::remove(shown, ignored);
    file.temporary->publish(Durable::no);
    file.temporary.reset();
  }
  file.write_viewer();
}

void ResultFile::append_history(const std::string& name, const std::string& unit, double time,
                                double value) {
  open_file().histories.append(name, unit, time, value);
}

ResultExtent ResultFile::flush() {
  auto& file = open_file();
  file.guarded([&] {
    file.histories.flush();
    hdf5::flush(file.file);
    hdf5::sync(file.file);
  });
  return {static_cast<std::int64_t>(file.frames.frames().size()), file.histories.rows()};
}

void ResultFile::close() {
  if (!file_) return;
  const auto file = std::move(file_);
  if (file->failed) return;
  file->guarded([&] {
    file->histories.flush();
    hdf5::flush(file->file);
  });
}

}  // namespace pliant
