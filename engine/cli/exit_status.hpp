#pragma once

namespace pliant::cli {

/// `missed`: what was measured does not reach what was asked for.
enum class ExitStatus { done = 0, missed = 1, bad_input = 2, run_failed = 3, interrupted = 4 };

}  // namespace pliant::cli
