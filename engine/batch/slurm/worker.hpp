#pragma once

#include <filesystem>

namespace pliant::batch::slurm {

/// What a task of a job array does: its runs, one after the other, with what comes of each beside
/// its folder. It leaves out those that are done, so that Slurm may start it again. After SIGTERM
/// the run at work ends with a checkpoint; false then. Throws InputError and OutputError.
bool work_on(const std::filesystem::path& array, int index);

}  // namespace pliant::batch::slurm
