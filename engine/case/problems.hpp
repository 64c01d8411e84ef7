#pragma once

#include <toml++/toml.h>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// Where a value comes from: a line of the case file, or a `--set` argument.
struct Place {
  std::string file;        ///< or "--set key=value"
  std::uint32_t line = 0;  ///< 0 for a setting

  std::string text() const;
};

/// The place of `node`. For nodes from settings, the name of the file is the setting.
Place place_of(const toml::node& node);
Place place_of(const toml::key& key);

/// Collects all problems of a case, so that one run of the reader reports them all.
class Problems {
 public:
  /// Adds "what; remedy". The same sentence about the same place is added once.
  void add(const Place& place, std::string_view what, std::string_view remedy);

  bool empty() const { return problems_.empty(); }
  std::size_t count() const { return problems_.size(); }

  /// One line each, `place: what; remedy`, in the order of the file, then the settings.
  std::string text() const;

 private:
  struct Problem {
    Place place;
    std::string sentence;
  };
  std::vector<Problem> problems_;
};

/// Description of a value for messages: "the text "a"", "3", "a list", ...
std::string describe(const toml::node& node);

/// The word of `known` nearest to `given` in insertions, deletions and replacements, or one that
/// begins with it; empty if none is similar.
std::string_view nearest_word(std::string_view given, const std::vector<std::string_view>& known);

/// "did you mean `nearest`?", or "`singular` is one of a, b, c" if no word is near.
std::string suggestion(std::string_view given, const std::vector<std::string_view>& known,
                       std::string_view otherwise);

/// Prefix that marks arguments of the command line as a file name.
inline constexpr std::string_view setting_mark = "--set ";

}  // namespace pliant
