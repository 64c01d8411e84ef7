#pragma once

#include <optional>

#include "engine/accuracy/ladders.hpp"
#include "engine/accuracy/record.hpp"
#include "engine/batch/job.hpp"

namespace pliant::accuracy {

/// One run of a rung: what to run, and where.
struct RungRun {
  std::filesystem::path folder;
  std::vector<std::string> command;  ///< without the folder
};

/// Writes what came of a run beside its folder, and reads it again. None where there is no such
/// file, where the run was another one, or where it gave no answer. Throws OutputError.
void keep(const RungRun& run, const batch::Outcome& outcome);
std::optional<batch::Outcome> kept(const RungRun& run);

/// Puts the answer of a run into the record of its rung. Throws InputError where the run does not
/// measure a target.
void add(RungRecord& record, const batch::Outcome& outcome, const std::vector<Target>& targets);

}  // namespace pliant::accuracy
