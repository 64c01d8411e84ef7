#pragma once

#include <filesystem>

/// The folder of a run: who may write to it, and which files may be there together.
namespace pliant {

/// Keeps a second run out of a folder; the lock ends with the object or the process.
class FolderLock {
 public:
  /// Throws OutputError when the folder cannot be opened or another run holds the lock.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  int descriptor_;
};

/// Prepares a folder for a new run: removes the checkpoints and the summary of an earlier run, and
/// incomplete files of a killed run. When this returns, the removal is on the disk, so that no file
/// of the new run is ever together with a checkpoint of the earlier one. The earlier result file
/// stays until the new one takes its name. Throws OutputError.
void clear_earlier_run(const std::filesystem::path& folder);

/// Removes the summary of a run whose results will change. Throws OutputError.
void remove_summary(const std::filesystem::path& folder);

}  // namespace pliant
