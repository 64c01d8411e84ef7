#pragma once

#include "engine/cli/actions.hpp"

namespace pliant::cli {

/// Measures the time to a given error, `pliant bench --accuracy`.
ExitStatus accuracy(const BenchArguments& arguments);

/// Throws InputError for options that belong to --accuracy without it, or the other way round.
void refuse_options_without_accuracy(const BenchArguments& arguments);

}  // namespace pliant::cli
