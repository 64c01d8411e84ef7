#pragma once

#include "engine/batch/batch_options.hpp"
#include "engine/batch/sweep.hpp"

namespace pliant::batch {

/// Runs a sweep. Each run is a process with the folder folder/runs/NAME and the log
/// folder/runs/NAME.log. On this machine, runs start while their estimates fit into memory. SIGINT,
/// SIGTERM and SIGHUP end the runs with checkpoints. Throws OutputError, and InputError for a
/// folder that contains another batch, or one that is running.
BatchEnd run_batch(const Sweep& sweep, const BatchOptions& options);

}  // namespace pliant::batch
