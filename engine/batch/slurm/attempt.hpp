#pragma once

#include <filesystem>
#include <optional>

#include "engine/batch/ledger.hpp"

/// The last attempt at a run in a task of Slurm, as a file next to its folder. Only the process of
/// `pliant batch` writes the ledger, since SQLite does not work on many shared disks.
namespace pliant::batch::slurm {

struct Attempt {
  RunRow row;  ///< without parameters
  int attempts_left = 1;
};

/// Throws OutputError.
void write_attempt(const std::filesystem::path& folder, const Attempt& attempt);

/// None if no task has started the run.
std::optional<Attempt> read_attempt(const std::filesystem::path& folder);

}  // namespace pliant::batch::slurm
