#pragma once

#include <filesystem>

/// The folder of a run: who may write into it, and which files may stand beside each other.
namespace pliant {

/// Keeps a second run out of a folder, by a lock that ends with the object or the process.
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

/// Makes a folder ready for a new run: removes the checkpoints and the summary of an earlier run,
/// and what a killed run left half-written. The removal is on the disk when this returns, so that
/// no later file of the new run ever stands beside a checkpoint of the earlier one. Its result file
/// stays until the new one takes its name. Throws OutputError.
void clear_earlier_run(const std::filesystem::path& folder);

/// Removes the summary of a run whose results are about to change. Throws OutputError.
void remove_summary(const std::filesystem::path& folder);

}  // namespace pliant
