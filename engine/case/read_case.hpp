#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>

#include "engine/case/case.hpp"

namespace pliant {

/// Everything that is wrong with a case file, one line each: `file:line: what; remedy`, or
/// `--set key=value: what; remedy`.
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads and checks a case file; no user input is checked anywhere else.
///
/// `path` is a TOML file, or a folder that holds a case.toml. Each of `settings` is "key=value" and
/// overrides the file: the value is TOML or plain text, elements of arrays are addressed by name or
/// by position (boundary.upper.velocity, body.0.material.youngs_modulus). Throws CaseError.
Case read_case(const std::filesystem::path& path, std::span<const std::string> settings = {});

}  // namespace pliant
