#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// A file of named arrays, bit for bit: what a checkpoint is made of.
///
/// Names may contain '/', which makes groups of them. The file appears under its name in `commit`,
/// whole and on the disk; without it nothing remains. Throws OutputError.
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

  /// Brings all to the disk, under the temporary name still; nothing more can be put.
  void finish();

  /// Gives the file its name, after finishing it.
  void commit();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads what ArchiveWriter wrote. Every array carries a checksum, so that damage is found.
/// Throws OutputError for a file that is missing, foreign, of another format or damaged, and for a
/// name or a type that is not there.
class ArchiveReader {
 public:
  explicit ArchiveReader(const std::filesystem::path& path);
  ArchiveReader(ArchiveReader&&) noexcept;
  ArchiveReader& operator=(ArchiveReader&&) noexcept;
  ~ArchiveReader();

  const std::filesystem::path& path() const;
  bool has(const std::string& name) const;
  std::vector<std::string> names(const std::string& group) const;  ///< alphabetical; may be none

  /// T: double, float, std::int32_t, std::int64_t or std::uint8_t, as it was put.
  template <class T>
  std::vector<T> get(const std::string& name) const;
  /// Into memory that is there already; its size must be that of the array.
  template <class T>
  void read(const std::string& name, std::span<T> values) const;
  template <class T>
  T scalar(const std::string& name) const;
  std::string text(const std::string& name) const;

  /// Reads everything once. Throws OutputError when anything is damaged.
  void verify() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace pliant
