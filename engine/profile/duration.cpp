#include "engine/profile/duration.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace pliant::profile {

namespace {

struct Unit {
  std::string_view name;
  double seconds;
};
constexpr std::array<Unit, 5> units = {
    {{"us", 1e-6}, {"ms", 1e-3}, {"s", 1}, {"min", 60}, {"h", 3600}}};

}  // namespace

double seconds_of(const std::string& text, const std::string& option) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  std::string_view name(rest, static_cast<std::size_t>(end - rest));
  name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
  if (error == std::errc() && number > 0 && std::isfinite(number)) {
    for (const Unit& unit : units) {
      if (name == unit.name) return number * unit.seconds;
    }
  }
  throw InputError(
      fmt::format("{} {}: not a duration; give a positive number with its unit (us, ms, s, min or "
                  "h), as in 16.7ms",
                  option, text));
}

}  // namespace pliant::profile
