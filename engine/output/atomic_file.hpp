#pragma once

#include <filesystem>
#include <string_view>

/// Files appear whole or not at all: they are written under a temporary name and renamed.
namespace pliant {

/// Where `path` is written until it is whole: beside it, so that renaming stays on one disk.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Forces `temporary` onto the disk and gives it the name `path`, replacing what had it.
/// Throws OutputError.
void publish(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Writes `text` to `path`; a reader sees the old file or the new one. Throws OutputError, and
/// leaves the old file and no temporary one behind then.
void write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace pliant
