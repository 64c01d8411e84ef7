#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace pliant {

enum class Colour { red = 31, yellow = 33 };

/// The text in a colour where `stream` leads to a terminal that has colours, and the user has not
/// set NO_COLOR (no-color.org); else the text itself.
std::string coloured(std::string_view text, Colour colour, std::FILE* stream);

}  // namespace pliant
