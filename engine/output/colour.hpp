#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace pliant {

enum class Colour { red = 31, yellow = 33 };

/// The text in a colour if `stream` is a terminal with colours and the user has not set NO_COLOR
/// (no-color.org); otherwise the text itself.
std::string coloured(std::string_view text, Colour colour, std::FILE* stream);

}  // namespace pliant
