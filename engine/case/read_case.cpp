#include "engine/case/read_case.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "engine/case/check_case.hpp"
#include "engine/case/elastic_constants.hpp"
#include "engine/case/settings.hpp"
#include "engine/case/table_reader.hpp"
#include "engine/case/vocabulary.hpp"

namespace pliant {
namespace {

toml::table parse(const std::string& text, const std::filesystem::path& file) {
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    if (error.description().find("utf-8") != std::string_view::npos) {
      throw CaseError(fmt::format("{}:{}: not UTF-8 text; save the file as UTF-8", file.string(),
                                  error.source().begin.line));
    }
    throw CaseError(fmt::format(
        "{}:{}: not TOML: {}; correct the line: write texts in quotes, lists in brackets, "
        "and every key once",
        file.string(), error.source().begin.line, error.description()));
  }
}

/// Names of the tables in the list `key`, empty where one has none.
std::vector<std::string> names_in(const toml::table& root, std::string_view key) {
  std::vector<std::string> names;
  const toml::array* tables = root[key].as_array();
  if (!tables) return names;
  for (const toml::node& element : *tables) {
    const toml::table* table = element.as_table();
    names.push_back(table ? (*table)["name"].value_or(std::string()) : std::string());
  }
  return names;
}

std::string default_name(const std::filesystem::path& file) {
  if (file.filename() == "case.toml") {
    // "." and ".." are not names of folders.
    const auto folder = std::filesystem::absolute(file).lexically_normal().parent_path();
    return folder.has_filename() ? folder.filename().string() : "case";
  }
  return file.stem().string();
}

}  // namespace

std::filesystem::path case_path(const std::filesystem::path& path) {
  std::error_code unreadable;  // reported where the file is opened
  return std::filesystem::is_directory(path, unreadable) ? path / "case.toml" : path;
}

std::string case_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw CaseError(
        fmt::format("{}: cannot be read; give the path of a case file, or of a folder "
                    "with a case.toml",
                    file.string()));
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Case read_case(const std::filesystem::path& path, std::span<const std::string> settings,
               MethodList methods) {
  const std::filesystem::path file = case_path(path);
  return parse_case(case_text(file), file, settings, methods);
}

Case parse_case(const std::string& text, const std::filesystem::path& file,
                std::span<const std::string> settings, MethodList methods) {
  toml::table root = parse(text, file);
  Problems problems;
  apply_settings(root, settings, problems);

  Reading reading{problems,
                  root,
                  std::filesystem::absolute(file).parent_path(),
                  2,
                  names_in(root, "body"),
                  names_in(root, "boundary"),
                  names_in(root, "measurement"),
                  methods};
  if (root["dimension"].value<int>() == 3) reading.dimension = 3;
  Case a_case;
  a_case.name = default_name(file);
  TableReader reader(root, "the case", Place{file.string(), 1}, reading);
  case_keys(reader, a_case);
  reader.finish();
  check_case(a_case, root, Place{file.string(), 1}, methods, problems);
  if (!problems.empty()) throw CaseError(problems.text());

  for (BodyCase& body : a_case.bodies) {
    body.material = elastic_constants(body.material_as_given);
    body.prony = prony_terms(body.material_as_given);
  }
  return a_case;
}

}  // namespace pliant
