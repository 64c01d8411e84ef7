#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// The text of a case, read from a file or built in code, with the keys of docs/case-reference.md.
///
///     pliant::CaseFile block;
///     block.set("discretisation.spacing", 0.05).set("time.end", 0.1);
///     block.set("material.rubber", R"({ model = "linear", density = 1000,
///                                       youngs_modulus = 1e5, poissons_ratio = 0.4 })");
///     block.add("body", "block").set("body.block.material", "rubber");
///     block.set("body.block.geometry", R"({ shape = "box", lower = [0, 0], upper = [1, 1] })");
///
/// Nothing is checked until a Simulation is made from it.
class CaseFile {
 public:
  /// A case without keys.
  CaseFile() = default;

  /// A TOML file, or a folder that holds a case.toml. Throws InputError when it cannot be read.
  static CaseFile read(const std::filesystem::path& path);

  /// TOML text; names of files in it are relative to `folder`.
  static CaseFile parse(std::string toml, const std::filesystem::path& folder = ".");

  /// Sets the value of a key, as `--set` does. Lists and tables are TOML text. Elements of lists
  /// are addressed by name or by position ("boundary.upper.velocity", "body.0.material"). Line
  /// breaks in a value count as spaces.
  CaseFile& set(std::string_view key, std::string_view value);
  CaseFile& set(std::string_view key, const char* value) {
    return set(key, std::string_view(value));
  }
  CaseFile& set(std::string_view key, double value);
  CaseFile& set(std::string_view key, int value);
  CaseFile& set(std::string_view key, bool value);
  CaseFile& set(std::string_view key, std::initializer_list<double> values);

  /// Adds an element to a list of tables ("body", "boundary", "contact", "measurement"). Its
  /// address is then LIST.NAME. The name must be new: `add` replaces nothing.
  CaseFile& add(std::string_view list, std::string_view name);

  const std::string& text() const { return text_; }  ///< the TOML text, without settings
  const std::vector<std::string>& settings() const { return settings_; }  ///< each as "key=value"
  const std::filesystem::path& file() const { return file_; }             ///< for messages

 private:
  std::string text_;
  std::vector<std::string> settings_;
  std::filesystem::path file_ = "case";
};

}  // namespace pliant
