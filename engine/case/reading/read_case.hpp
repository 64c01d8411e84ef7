#pragma once

#include <filesystem>
#include <pliant/error.hpp>
#include <span>
#include <string>

#include "engine/case/method_rules.hpp"

namespace pliant {

/// All problems of a case file, one line each: `file:line: what; remedy`, or `--set key=value:
/// what; remedy`.
class CaseError : public InputError {
 public:
  using InputError::InputError;
};

/// Reads and checks a case file; no user input is checked anywhere else.
///
/// `path` is a TOML file, or a folder that contains a case.toml. Each of `settings` is "key=value"
/// and overrides the file. The value is TOML or plain text; elements of arrays are addressed by
/// name or by position (boundary.upper.velocity, body.0.material.youngs_modulus). The case names
/// one of `methods`. Throws CaseError.
Case read_case(const std::filesystem::path& path, std::span<const std::string> settings,
               MethodList methods);

/// The two halves of reading: the file of a case, which is `path` or its case.toml, and its text.
/// Throws CaseError when it cannot be read.
std::filesystem::path case_path(const std::filesystem::path& path);
std::string case_text(const std::filesystem::path& file);

/// Checks the text of a case. `file` names it in messages; files named in the text are relative to
/// its folder. Throws CaseError.
Case parse_case(const std::string& text, const std::filesystem::path& file,
                std::span<const std::string> settings, MethodList methods);

}  // namespace pliant
