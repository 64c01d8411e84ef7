#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/engine/case/written_case.hpp"

/// Wrong case files and their error messages.
namespace pliant::tests {

struct Fault {
  const char* name;
  std::string text;
  const char* message;

  friend std::ostream& operator<<(std::ostream& stream, const Fault& fault) {
    return stream << fault.name;
  }
};

inline std::string name_of(const testing::TestParamInfo<Fault>& fault) { return fault.param.name; }

/// The block with `part` of its file replaced.
inline std::string broken(const std::string& part, const std::string& replacement) {
  return with(block_case, part, replacement);
}

/// The block with more lines, starting at line 10.
inline std::string extended(const std::string& lines) { return block_case + lines; }

/// A measurement of the block with the given keys, starting at line 12.
inline std::string measuring(const std::string& keys) {
  return extended("[[measurement]]\nname = \"m\"\n" + keys);
}

inline const std::string geometry = R"({ shape = "box", lower = [0, 0], upper = [1, 2] })";
inline const std::string material =
    R"({ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 })";

}  // namespace pliant::tests
