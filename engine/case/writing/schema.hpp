#pragma once

#include <string>

#include "engine/case/method_rules.hpp"

namespace pliant {

/// The JSON Schema (draft 7) of case files, from the vocabulary of the reader. Editors use it to
/// complete and check keys.
///
/// It admits every case that the reader admits; only the reader checks what depends on several
/// keys, on the dimension or on the method.
std::string case_schema_json(MethodList methods);

}  // namespace pliant
