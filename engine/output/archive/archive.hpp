#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// A file of named arrays, stored bitwise, for checkpoints.
///
/// A name may contain '/', which puts the array into a group. In `commit` the file gets its name,
/// complete and on the disk; without `commit` no file remains. Throws OutputError.
class ArchiveWriter {
 public:
  explicit ArchiveWriter(const std::filesystem::path& path);
  ArchiveWriter(ArchiveWriter&&) noexcept;
  ArchiveWriter& operator=(ArchiveWriter&&) noexcept;
  ~ArchiveWriter();

  void put(const std::string& name, std::span<const double> values);
  void put(const std::string& name, std::span<const float> values);
  void put(const std::string& name, std::span<const std::int32_t> values);
  void put(const std::string& name, std::span<const std::int64_t> values);
  void put(const std::string& name, std::span<const std::uint8_t> values);
  void put(const std::string& name, double value);
  void put(const std::string& name, std::int64_t value);
  void put(const std::string& name, std::string_view text);

  /// Forces everything onto the disk, still under the temporary name; no more arrays can be put.
  void finish();

  /// Finishes the file and gives it its name.
  void commit();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads a file of ArchiveWriter. Every array has a checksum that reveals damage. Throws
/// OutputError for a file that is missing, damaged, of another format or not an archive, and for a
/// name or a type that does not exist.
class ArchiveReader {
 public:
  explicit ArchiveReader(const std::filesystem::path& path);
  ArchiveReader(ArchiveReader&&) noexcept;
  ArchiveReader& operator=(ArchiveReader&&) noexcept;
  ~ArchiveReader();

  const std::filesystem::path& path() const;
  bool has(const std::string& name) const;
  std::vector<std::string> names(const std::string& group) const;  ///< alphabetical; may be empty

  /// T: double, float, std::int32_t, std::int64_t or std::uint8_t, as it was written.
  template <class T>
  std::vector<T> get(const std::string& name) const;
  /// Reads into existing memory, whose size must be that of the array.
  template <class T>
  void read(const std::string& name, std::span<T> values) const;
  template <class T>
  T scalar(const std::string& name) const;
  std::string text(const std::string& name) const;

  /// Reads everything once. Throws OutputError if anything is damaged.
  void verify() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace pliant
