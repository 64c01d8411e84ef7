#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pliant::batch {

/// Starts a program in its own process group, without input, and with its output in `log`. It holds
/// a lock on `lock` until it ends, even after the end of this process. If it calls end_with_parent,
/// it gets SIGTERM when this process ends. Throws OutputError.
pid_t spawn(const std::vector<std::string>& command, const std::filesystem::path& log,
            const std::filesystem::path& lock);

bool is_locked(const std::filesystem::path& lock);

/// Locks a file until this process ends; false if another process has locked it. Throws
/// OutputError.
bool lock_for_life(const std::filesystem::path& lock);

/// In a process started by `spawn`, requests SIGTERM for when its parent ends. Does nothing in
/// other processes.
void end_with_parent();

}  // namespace pliant::batch
