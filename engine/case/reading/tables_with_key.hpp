#pragma once

#include <string>
#include <string_view>

#include "engine/case/method_rules.hpp"

namespace pliant {

/// The tables of a case that have `key`, for messages, as in "[time]" or "[output] or [remeshing]".
/// Empty if there are none. Of tables whose keys depend on a word, such as [[boundary]], it knows
/// the keys of the default.
std::string tables_with_key(std::string_view key, MethodList methods);

}  // namespace pliant
