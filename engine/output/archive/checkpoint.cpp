#include "engine/output/archive/checkpoint.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <pliant/error.hpp>

#include <cerrno>
#include <system_error>

#include "engine/output/atomic_file.hpp"
#include "engine/output/error.hpp"

namespace pliant {
namespace {

std::filesystem::path last_of(const std::filesystem::path& folder) {
  return folder / "checkpoint.h5";
}
std::filesystem::path previous_of(const std::filesystem::path& folder) {
  return folder / "checkpoint.previous.h5";
}

/// Gives the last checkpoint a second name; it keeps the first until the new one takes it.
void keep_last(const std::filesystem::path& folder) {
  const auto last = last_of(folder);
  TemporaryFile second_name(previous_of(folder));
  std::error_code ignored;
  std::filesystem::remove(second_name.path(), ignored);  // left by a killed run
  if (::link(last.c_str(), second_name.path().c_str()) == 0)
    return second_name.publish(Durable::yes);
  if (errno != ENOENT) throw OutputError::system(last, "keep it as the previous one", errno);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& folder,
                      const std::function<void(ArchiveWriter&)>& fill) {
  ArchiveWriter archive(last_of(folder));
  fill(archive);
  archive.finish();
  keep_last(folder);
  archive.commit();
}

ArchiveReader open_checkpoint(const std::filesystem::path& folder) {
  std::error_code unreadable;
  if (!std::filesystem::exists(last_of(folder), unreadable) &&
      !std::filesystem::exists(previous_of(folder), unreadable)) {
    throw InputError(fmt::format(
        "{}: there is no checkpoint to continue from; run without --resume. Checkpoints "
        "are written with the frames, every output.checkpoint_every, and when a run is "
        "interrupted",
        folder.string()));
  }
  try {
    ArchiveReader archive(last_of(folder));
    archive.verify();
    return archive;
  } catch (const OutputError&) {
    if (!std::filesystem::exists(previous_of(folder))) throw;
  }
  ArchiveReader archive(previous_of(folder));
  archive.verify();
  return archive;
}

void put_extent(ArchiveWriter& archive, const std::string& group, const ResultExtent& extent) {
  archive.put(group + "/frames", extent.frames);
  for (const auto& [name, rows] : extent.history_rows)
    archive.put(group + "/history_rows/" + name, rows);
}

ResultExtent get_extent(const ArchiveReader& archive, const std::string& group) {
  ResultExtent extent;
  extent.frames = archive.scalar<std::int64_t>(group + "/frames");
  for (const auto& name : archive.names(group + "/history_rows"))
    extent.history_rows[name] = archive.scalar<std::int64_t>(group + "/history_rows/" + name);
  return extent;
}

}  // namespace pliant
