#include "engine/output/colour.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace pliant {

namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

bool has_colours(std::FILE* stream) {
  return variable("NO_COLOR").empty() && variable("TERM") != "dumb" &&
         ::isatty(::fileno(stream)) != 0;
}

}  // namespace

std::string coloured(std::string_view text, Colour colour, std::FILE* stream) {
  if (!has_colours(stream)) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", static_cast<int>(colour), text);
}

}  // namespace pliant
