#pragma once

#include "engine/batch/batch_options.hpp"
#include "engine/batch/sweep.hpp"

namespace pliant::batch {

/// Runs a sweep: each run is a process of its own in folder/runs/NAME, with its output in
/// folder/runs/NAME.log. On this machine, runs start while their estimates fit into the memory.
/// SIGINT, SIGTERM and SIGHUP end the runs with checkpoints. Throws OutputError, and InputError for
/// a folder that holds another batch, or one that is at work.
BatchEnd run_batch(const Sweep& sweep, const BatchOptions& options);

}  // namespace pliant::batch
