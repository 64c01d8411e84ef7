#pragma once

#include <string>

#include "engine/case/method_rules.hpp"

namespace pliant {

/// The JSON Schema (draft 7) of case files, from the vocabulary that the reader checks files
/// against. Editors complete and check keys with it.
///
/// It admits every case that the reader admits. What depends on more than one key of a table, or on
/// the dimension or the method, only the reader checks.
std::string case_schema_json(MethodList methods);

}  // namespace pliant
