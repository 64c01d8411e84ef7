#pragma once

#include <optional>

#include "engine/accuracy/ladders.hpp"
#include "engine/accuracy/record.hpp"
#include "engine/batch/job.hpp"

namespace pliant::accuracy {

struct RungRun {
  std::filesystem::path folder;
  std::vector<std::string> command;  ///< without the folder
};

/// Writes the outcome of a run to a file next to its folder, and reads it again. None if there is
/// no such file, if it belongs to another run, or if the run had no result. Throws OutputError.
void keep(const RungRun& run, const batch::Outcome& outcome);
std::optional<batch::Outcome> kept(const RungRun& run);

/// Adds the result of a run to the record of its rung. Throws InputError if the run does not
/// measure a target.
void add(RungRecord& record, const batch::Outcome& outcome, const std::vector<Target>& targets);

}  // namespace pliant::accuracy
