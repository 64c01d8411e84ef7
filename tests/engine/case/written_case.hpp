#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"

namespace pliant::tests {

/// A small valid case, which tests extend or modify.
inline const std::string block_case = R"(title = "a block"
[discretisation]
spacing = 0.1
[time]
end = 1
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 2] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
)";

/// The start of a case of neo-Hookean bodies with E = 100 Pa, nu = 0.3 and a density of 1 kg/m^3.
/// A spacing [m] and the end [s] are as case files write them.
inline std::string rubber_case(const std::string& method, int dimension, const std::string& spacing,
                               const std::string& end) {
  return "method = \"" + method + "\"\ndimension = " + std::to_string(dimension) +
         "\ndiscretisation = { spacing = " + spacing + " }\ntime = { end = " + end + R"( }
[material.rubber]
model = "neo_hookean"
density = 1
youngs_modulus = 100
poissons_ratio = 0.3
)";
}

/// Reads `text` as the file block.toml in a temporary folder.
inline Case read_text(const std::string& text, const std::vector<std::string>& settings = {}) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("pliant_case_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "block.toml") << text;
  struct Cleaner {
    std::filesystem::path path;
    ~Cleaner() { std::filesystem::remove_all(path); }
  } cleaner{folder};
  return read_case(folder / "block.toml", settings);
}

/// The reader's error message for `text`, without the folder; empty if there is none.
inline std::string complaint(const std::string& text,
                             const std::vector<std::string>& settings = {}) {
  try {
    read_text(text, settings);
    return "";
  } catch (const CaseError& error) {
    std::string message = error.what();
    const std::string folder =
        (std::filesystem::temp_directory_path() / ("pliant_case_" + std::to_string(getpid())))
            .string() +
        "/";
    for (std::size_t at = message.find(folder); at != message.npos; at = message.find(folder)) {
      message.erase(at, folder.size());
    }
    return message;
  }
}

/// `text` with its first `part` replaced.
inline std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const std::size_t at = text.find(part);
  return at == text.npos ? "no such part: " + part : text.replace(at, part.size(), replacement);
}

}  // namespace pliant::tests
