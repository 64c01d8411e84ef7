#pragma once

#include <string>

#include "engine/case/method_rules.hpp"

namespace pliant {

/// docs/case-reference.md: every key of case files with type, unit, default and meaning, from the
/// vocabulary of the reader.
std::string case_reference_markdown(MethodList methods);

}  // namespace pliant
