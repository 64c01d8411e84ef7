#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/geometry/surface_mesh.hpp"

/// Common parts of the readers of mesh files.
namespace pliant {

/// The content of a file, and messages about places in it.
struct MeshFile {
  std::string name;
  std::string content;

  /// Throws MeshError: "name:12: what" for the line at `offset`.
  [[noreturn]] void refuse_line(std::size_t offset, const std::string& what,
                                const std::string& remedy) const;
  /// Throws MeshError: "name: byte 84: what".
  [[noreturn]] void refuse_byte(std::size_t offset, const std::string& what,
                                const std::string& remedy) const;
  /// Throws MeshError when the file ends at `offset` before its announced content.
  [[noreturn]] void refuse_end(std::size_t offset, const std::string& missing) const;
};

/// Throws MeshError when `file` is not a regular file or cannot be read.
MeshFile load_mesh_file(const std::filesystem::path& file);

/// The extension of a file in lower case, for example ".stl".
std::string lower_ending(const std::filesystem::path& file);

/// Reads a text file word by word.
class MeshText {
 public:
  explicit MeshText(const MeshFile& file, std::size_t start = 0) : file_(&file), at_(start) {}

  /// The next word of the file, empty at its end.
  std::string_view word();
  /// The next word of this line, empty at its end.
  std::string_view word_of_line();
  /// Moves to the next line; false at the end of the file.
  bool next_line();
  /// `word` as a number, finite; `what` names it in messages.
  double number(std::string_view word, std::string_view what) const;
  std::int64_t integer(std::string_view word, std::string_view what) const;
  /// Where the search for the next word starts.
  std::size_t offset() const { return at_; }
  /// Where the last word begins.
  std::size_t word_start() const { return word_start_; }
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    file_->refuse_line(word_start_, what, remedy);
  }

 private:
  const MeshFile* file_;
  std::size_t at_;
  std::size_t word_start_ = 0;
};

/// Adds the triangles of a polygon, as a fan from its first corner.
void add_fan(SurfaceMesh& mesh, const std::vector<std::int32_t>& corners);

/// The value at `bytes`, for any alignment. Files and processors are little endian.
template <class Value>
Value value_at(const char* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

inline constexpr std::string_view save_again = "save it again from the program that made it";

SurfaceMesh read_stl(const MeshFile& file);
SurfaceMesh read_obj(const MeshFile& file);
SurfaceMesh read_ply(const MeshFile& file);

}  // namespace pliant
