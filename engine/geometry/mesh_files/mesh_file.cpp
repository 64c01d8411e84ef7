#include "engine/geometry/mesh_files/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

namespace pliant {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

void MeshFile::refuse_line(std::size_t offset, const std::string& what,
                           const std::string& remedy) const {
  const auto end = content.begin() + static_cast<std::ptrdiff_t>(std::min(offset, content.size()));
  const auto line = 1 + std::count(content.begin(), end, '\n');
  throw MeshError(fmt::format("{}:{}: {}", name, line, what), remedy);
}

void MeshFile::refuse_byte(std::size_t offset, const std::string& what,
                           const std::string& remedy) const {
  throw MeshError(fmt::format("{}: byte {}: {}", name, offset, what), remedy);
}

void MeshFile::refuse_end(std::size_t offset, const std::string& missing) const {
  refuse_byte(offset, "the file ends before " + missing, std::string(save_again));
}

bool MeshText::next_line() {
  const std::size_t end = file_->content.find('\n', at_);
  at_ = end == std::string::npos ? file_->content.size() : end + 1;
  return at_ < file_->content.size();
}

std::string_view MeshText::word_of_line() {
  const std::string& text = file_->content;
  while (at_ < text.size() && is_space(text[at_])) ++at_;
  word_start_ = at_;
  while (at_ < text.size() && text[at_] != '\n' && !is_space(text[at_])) ++at_;
  return std::string_view(text).substr(word_start_, at_ - word_start_);
}

std::string_view MeshText::word() {
  std::string_view found = word_of_line();
  while (found.empty() && next_line()) found = word_of_line();
  return found;
}

double MeshText::number(std::string_view word, std::string_view what) const {
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (word.empty() || error != std::errc() || end != digits.data() + digits.size()) {
    refuse(fmt::format("{} must be a number, found \"{}\"", what, word), std::string(save_again));
  }
  if (!std::isfinite(value)) {
    refuse(fmt::format("{} is not finite, found \"{}\"", what, word),
           "remove the vertex, or give it a place");
  }
  return value;
}

std::int64_t MeshText::integer(std::string_view word, std::string_view what) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
    refuse(fmt::format("{} must be a whole number, found \"{}\"", what, word),
           std::string(save_again));
  }
  return value;
}

void add_fan(SurfaceMesh& mesh, const std::vector<std::int32_t>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

MeshFile load_mesh_file(const std::filesystem::path& file) {
  // Neither a folder nor a pipe, which may be endless.
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(file, ignored);
  std::ifstream stream;
  if (is_file) stream.open(file, std::ios::binary);
  if (!is_file || !stream) {
    throw MeshError(fmt::format("{}: cannot be read", file.string()),
                    "give the path of the mesh from the folder of the case file");
  }
  return {file.string(), {std::istreambuf_iterator<char>(stream), {}}};
}

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

}  // namespace pliant
