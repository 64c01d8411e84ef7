#pragma once

#include <filesystem>
#include <string_view>

/// Files appear whole or not at all: they are written under a temporary name and renamed.
namespace pliant {

/// Whether a file must survive a loss of power, or only the end of the process: forcing it onto the
/// disk takes milliseconds.
enum class Durable { no, yes };

/// Where a file is written until it is whole: beside its place, so that renaming stays on one disk.
/// Without `publish` it is removed in the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& final_path);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  const std::filesystem::path& path() const { return path_; }

  /// Gives the file its final name, replacing what had it. Throws OutputError.
  void publish(Durable durable);

 private:
  std::filesystem::path final_path_, path_;
  bool published_ = false;
};

/// Writes `text` to `path`; a reader sees the old file or the new one. Throws OutputError, and
/// leaves the old file and no temporary one behind then.
void write_atomically(const std::filesystem::path& path, std::string_view text, Durable durable);

}  // namespace pliant
