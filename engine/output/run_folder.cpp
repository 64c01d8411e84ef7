#include "engine/output/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "engine/output/error.hpp"

namespace pliant {
namespace {

/// Removes those of `names` that exist, in this order, and forces the removal onto the disk.
void remove_files(const std::filesystem::path& folder,
                  std::initializer_list<std::string_view> names) {
  bool removed = false;
  for (const auto name : names) {
    const auto path = folder / name;
    if (::unlink(path.c_str()) == 0)
      removed = true;
    else if (errno != ENOENT)
      throw OutputError::system(path, "remove what an earlier run left", errno);
  }
  if (!removed) return;
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw OutputError::system(folder, "open this folder", errno);
  ::fsync(descriptor);  // some file systems cannot sync a folder; the files are removed anyway
  ::close(descriptor);
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) throw OutputError::system(folder, "open this folder", errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw OutputError(folder, "another run is writing into this folder",
                    "wait for it, or choose another folder with --out");
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void clear_earlier_run(const std::filesystem::path& folder) {
  // If the process is killed between two removals, the earlier run can still be resumed while it
  // has its last checkpoint.
  remove_files(folder,
               {"checkpoint.previous.h5", "checkpoint.previous.h5.partial", "checkpoint.h5.partial",
                "checkpoint.h5", "summary.json", "summary.json.partial", "result.h5.partial"});
}

void remove_summary(const std::filesystem::path& folder) {
  remove_files(folder, {"summary.json", "summary.json.partial"});
}

}  // namespace pliant
