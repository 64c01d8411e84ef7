#pragma once

#include <toml++/toml.h>
#include <span>
#include <string>

#include "engine/case/problems.hpp"

namespace pliant {

/// Inserts the settings of a command line, each `key=value`, into the table of a case file.
///
/// The value is TOML. Anything else is text, so that time.step=cfl needs no quotes. Elements of
/// arrays are addressed by position from 0, tables in an array also by name: body.0.name=slab,
/// boundary.upper.velocity=[0,-10].
void apply_settings(toml::table& root, std::span<const std::string> settings, Problems& problems);

}  // namespace pliant
