#pragma once

#include <string_view>

/// Case files of cases/, built into the program, so that an installed program measures the same
/// cases from any folder.
namespace pliant::bench {

extern const std::string_view rotating_cylinder_text;
extern const std::string_view compression_hyperelastic_text;
extern const std::string_view block_cut_text;

}  // namespace pliant::bench
