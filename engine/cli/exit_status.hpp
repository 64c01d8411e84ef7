#pragma once

namespace pliant::cli {

/// `missed`: the result of a measurement is worse than requested.
enum class ExitStatus { done = 0, missed = 1, bad_input = 2, run_failed = 3, interrupted = 4 };

}  // namespace pliant::cli
