#pragma once

#include <filesystem>
#include <string_view>

/// Files appear complete or not at all: they are written under a temporary name and renamed.
namespace pliant {

/// Whether a file must survive a loss of power, or only the end of the process. Forcing it onto the
/// disk takes milliseconds.
enum class Durable { no, yes };

/// The temporary name of a file until it is complete, in the same folder, so that it can be
/// renamed. Without `publish` the file is removed at the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& final_path);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  const std::filesystem::path& path() const { return path_; }

  /// Gives the file its final name and replaces an existing file. Throws OutputError.
  void publish(Durable durable);

 private:
  std::filesystem::path final_path_, path_;
  bool published_ = false;
};

/// Writes `text` to `path`; a reader sees either the old file or the new one. Throws OutputError;
/// then the old file remains, and no temporary one.
void write_atomically(const std::filesystem::path& path, std::string_view text, Durable durable);

}  // namespace pliant
