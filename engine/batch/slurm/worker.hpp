#pragma once

#include <filesystem>

namespace pliant::batch::slurm {

/// Executes a task of a job array: runs its runs one after another and writes the outcome of each
/// to a file next to its folder. Skips runs that are done, so that Slurm may restart the task.
/// After SIGTERM, the current run ends with a checkpoint, and the result is false. Throws
/// InputError and OutputError.
bool work_on(const std::filesystem::path& array, int index);

}  // namespace pliant::batch::slurm
