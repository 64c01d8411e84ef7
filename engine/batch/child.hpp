#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pliant::batch {

/// Starts a program in a process group of its own, without input, with its output in `log`. It
/// holds a lock on `lock` until it ends, even when this process has ended before. It gets SIGTERM
/// when this process ends, if it calls end_with_parent. Throws OutputError.
pid_t spawn(const std::vector<std::string>& command, const std::filesystem::path& log,
            const std::filesystem::path& lock);

/// Whether a process holds a lock on the file.
bool is_locked(const std::filesystem::path& lock);

/// Locks a file until this process ends; false when another one has locked it. Throws OutputError.
bool lock_for_life(const std::filesystem::path& lock);

/// In a process that `spawn` has started, asks the system to send it SIGTERM when its parent ends.
/// Does nothing in others.
void end_with_parent();

}  // namespace pliant::batch
