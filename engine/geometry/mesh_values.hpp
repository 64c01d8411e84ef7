#pragma once

#include "engine/geometry/mesh_files/mesh_file.hpp"

namespace pliant {

/// Reads the numbers of a mesh file in order, as words of text or as bytes.
class MeshValues {
 public:
  enum class Encoding { text, little_endian, big_endian };

  MeshValues(const MeshFile& file, Encoding encoding, std::size_t start)
      : file_(&file), encoding_(encoding), text_(file, start), at_(start) {}

  /// The next number; `bytes` is its width in binary files, 4 or 8, and `what` names it in
  /// messages. Throws MeshError at the end of the file, and for words that are not numbers.
  std::int64_t integer(int bytes, std::string_view what);
  double real(int bytes, std::string_view what);
  /// A number that must not be negative.
  std::int64_t count(int bytes, std::string_view what);

  /// Where the last number begins.
  std::size_t start() const { return is_text() ? text_.word_start() : start_; }
  /// Where the next number begins; in text, possibly with white space before it.
  std::size_t offset() const { return is_text() ? text_.offset() : at_; }
  bool is_text() const { return encoding_ == Encoding::text; }
  /// Throws MeshError with the line or the byte of the last number.
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const;

 private:
  template <class Value>
  Value take(std::string_view what);

  const MeshFile* file_;
  Encoding encoding_;
  MeshText text_;
  std::size_t at_;
  std::size_t start_ = 0;
};

}  // namespace pliant
