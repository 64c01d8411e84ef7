#include <pliant/case_file.hpp>
#include <pliant/error.hpp>

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/reading/read_case.hpp"

namespace pliant {

CaseFile CaseFile::read(const std::filesystem::path& path) {
  CaseFile file;
  file.file_ = case_path(path);
  file.text_ = case_text(file.file_);
  return file;
}

CaseFile CaseFile::parse(std::string toml, const std::filesystem::path& folder) {
  CaseFile file;
  file.text_ = std::move(toml);
  file.file_ = folder / "case";
  return file;
}

CaseFile& CaseFile::set(std::string_view key, std::string_view value) {
  std::string line(value);
  std::ranges::replace(line, '\n', ' ');  // TOML requires an inline table on one line
  settings_.push_back(fmt::format("{}={}", key, line));
  return *this;
}

CaseFile& CaseFile::set(std::string_view key, double value) {
  return set(key, fmt::format("{}", value));
}

CaseFile& CaseFile::set(std::string_view key, int value) {
  return set(key, fmt::format("{}", value));
}

CaseFile& CaseFile::set(std::string_view key, bool value) {
  return set(key, fmt::format("{}", value));
}

CaseFile& CaseFile::set(std::string_view key, std::initializer_list<double> values) {
  return set(key, fmt::format("[{}]", fmt::join(values, ", ")));
}

CaseFile& CaseFile::add(std::string_view list, std::string_view name) {
  text_ += fmt::format("\n[[{}]]\nname = \"{}\"\n", list, name);
  return *this;
}

}  // namespace pliant
