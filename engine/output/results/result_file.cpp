#include "engine/output/results/result_file.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <optional>
#include <stdexcept>
#include <system_error>

#include "engine/output/atomic_file.hpp"
#include "engine/output/error.hpp"
#include "engine/output/hdf5/commit_driver.hpp"
#include "engine/output/hdf5/hdf5.hpp"
#include "engine/output/results/frame_store.hpp"
#include "engine/output/results/history_store.hpp"
#include "engine/output/results/surface_store.hpp"
#include "engine/output/results/xdmf.hpp"
#include "engine/output/run_folder.hpp"

// The file of a killed process is readable, since it changes by commits (see commit_driver.cpp).
// These require that arrays only grow and are indexed by extensible arrays, as in the format of
// HDF5 1.10. But the superblock of that format marks a file as open for writing, so readers would
// refuse it after a kill. Hence the superblock has the first format, and everything else the later
// one.

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::Handle;

Handle with_extensible_arrays(Handle file) {
  checked(H5Fset_libver_bounds(file, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the format");
  return file;
}

void describe(hid_t file, const RunDescription& run) {
  const auto group = hdf5::create_group(file, "run");
  hdf5::write_attribute(group, "case", run.case_name);
  hdf5::write_attribute(group, "title", run.title);
  hdf5::write_attribute(group, "method", run.method);
  hdf5::write_attribute(group, "version", run.version);
  hdf5::write_attribute(group, "dimension", run.dimension);
  hdf5::write_attribute(group, "identity", run.identity);
  hdf5::write_text(group, "case.toml", run.resolved_case);
}

void require_identity(hid_t file, const std::filesystem::path& path, const RunDescription& run) {
  const auto group = hdf5::open_group(file, "run");
  if (hdf5::has_attribute(group, "identity") &&
      hdf5::read_text_attribute(group, "identity") == run.identity)
    return;
  throw InputError(fmt::format(
      "{}: belongs to another run than the checkpoint; run without --resume, which starts anew, or "
      "put back the result file of the checkpoint's run",
      path.string()));
}

/// Replaces the text of the case, which differs when a run continues to a later end. The new text
/// is written to new space, since a commit must not reuse space that it frees.
void update_case(hid_t file, const std::string& resolved_case) {
  const auto group = hdf5::open_group(file, "run");
  if (hdf5::read_text(group, "case.toml") == resolved_case) return;
  constexpr auto name = "case.toml", next = "case.toml.next";
  hdf5::write_text(group, next, resolved_case);
  checked(H5Ldelete(group, name, H5P_DEFAULT), "replace the case");
  checked(H5Lmove(group, next, group, name, H5P_DEFAULT, H5P_DEFAULT), "replace the case");
}

}  // namespace

struct ResultFile::File {
  FolderLock lock;
  std::filesystem::path path, settings;
  std::string case_text;
  std::filesystem::path viewer, surface_viewer;
  std::optional<TemporaryFile> temporary;  ///< of a new file, until its first frame is complete
  bool failed = false;
  Handle file;
  FrameStore frames;
  SurfaceStore surfaces;
  HistoryStore histories;
  XdmfSeries series{"result.h5", "particles"}, surface_series{"result.h5", "surface"};
  std::size_t shown = 0;  ///< frames in `series`

  File(FolderLock lock_of_folder, const std::filesystem::path& folder, std::string resolved_case,
       bool existing)
      : lock(std::move(lock_of_folder)),
        path(folder / "result.h5"),
        settings(folder / "case.resolved.toml"),
        case_text(std::move(resolved_case)),
        viewer(folder / "result.xdmf"),
        surface_viewer(folder / "surface.xdmf"),
        temporary(existing ? std::nullopt : std::make_optional<TemporaryFile>(path)),
        file(with_extensible_arrays(
            existing ? hdf5::open_committed(path)
                     : hdf5::create_committed(temporary->path(), H5F_LIBVER_EARLIEST))),
        frames(file),
        surfaces(file),
        histories(file) {}

  /// Runs `change`; if it fails, the file stays in the state of the last commit.
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

  void write_settings() const { write_atomically(settings, case_text, Durable::no); }

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
    FolderLock lock(folder);
    clear_earlier_run(folder);
    auto file = std::make_unique<File>(std::move(lock), folder, run.resolved_case, false);
    file->guarded([&] { describe(file->file, run); });
    return ResultFile(std::move(file));
  } catch (const hdf5::Failure& failure) {
    throw failure.on(path);
  }
}

ResultFile ResultFile::resume(const std::filesystem::path& folder, const RunDescription& run,
                              const ResultExtent& extent) {
  const auto path = folder / "result.h5";
  hdf5::silence();
  try {
    FolderLock lock = cut(folder, run, extent);
    // A reopened file does not reuse the space that this has freed, as commits require.
    auto file = std::make_unique<File>(std::move(lock), folder, run.resolved_case, true);
    file->write_settings();
    file->write_viewer();
    return ResultFile(std::move(file));
  } catch (const hdf5::Failure& failure) {
    throw failure.on(path);
  }
}

FolderLock ResultFile::cut(const std::filesystem::path& folder, const RunDescription& run,
                           const ResultExtent& extent) {
  File file(FolderLock(folder), folder, run.resolved_case, true);
  require_identity(file.file, file.path, run);
  const auto rows = file.histories.rows();
  auto complete = static_cast<std::int64_t>(file.frames.frames().size()) >= extent.frames;
  for (const auto& [name, count] : extent.history_rows)
    complete = complete && (count == 0 || (rows.contains(name) && rows.at(name) >= count));
  if (!complete)
    throw OutputError(file.path, "holds fewer frames or measurements than at the checkpoint",
                      "put back the file that belongs to the checkpoint, or run without --resume");
  remove_summary(folder);
  file.guarded([&] {
    file.frames.truncate(static_cast<std::size_t>(extent.frames));
    file.surfaces.truncate(static_cast<std::size_t>(extent.frames));
    file.histories.truncate(extent.history_rows);
    update_case(file.file, run.resolved_case);
    hdf5::flush(file.file);
  });
  return std::move(file.lock);
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
    // Remove those of an earlier run, whose frames are replaced now.
    for (const auto& stale : {file.viewer, file.surface_viewer, file.settings})
      std::filesystem::remove(stale, ignored);
    file.temporary->publish(Durable::no);
    file.temporary.reset();
    file.write_settings();
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
