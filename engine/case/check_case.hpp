#pragma once

#include "engine/case/method_rules.hpp"
#include "engine/case/problems.hpp"

namespace pliant {

/// Adds what is wrong between keys that are each right by themselves: sizes that do not fit the
/// spacing, names given twice, measurements of nothing. Values that could not be read are skipped.
///
/// `root` is the file that the case came from, `start` its first line.
void check_case(const Case& a_case, const toml::table& root, const Place& start, MethodList methods,
                Problems& problems);

}  // namespace pliant
