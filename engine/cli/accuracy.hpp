#pragma once

#include "engine/cli/actions.hpp"

namespace pliant::cli {

/// Measures the time to a given error, `pliant bench --accuracy`.
ExitStatus accuracy(const BenchArguments& arguments);

/// Throws InputError for options of --accuracy without it, and for other options with it.
void refuse_options_without_accuracy(const BenchArguments& arguments);

}  // namespace pliant::cli
