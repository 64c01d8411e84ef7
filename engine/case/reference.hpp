#pragma once

#include <string>

namespace pliant {

/// docs/case-reference.md: every key of case files with type, unit, default and meaning, from the
/// vocabulary that the reader checks files against.
std::string case_reference_markdown();

}  // namespace pliant
