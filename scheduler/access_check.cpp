#include "scheduler/access_check.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "scheduler/access_probes.hpp"

// Three kinds of probes look at the same experiment.
//
//     recorder   notes what each node has written, and compares all other memory before and after
//     disturber  disturbs all that a node has not declared while it runs, and stops at the first
//                node that writes something else than the recorder has noted: it has read
//                something undeclared
//     culprits   the disturber again, for this node alone with one field at a time, then with one
//                block of it at a time
//
// What has been found is left alone from then on, and the disturber starts again until it finds
// nothing more.
namespace pliant::scheduler {

namespace {

using Experiment = std::function<void(AccessProbe&)>;

std::optional<Deviation> deviation_under(const Disturbance& disturbance,
                                         const Experiment& experiment,
                                         const std::vector<std::size_t>& fingerprints) {
  Disturber disturber(disturbance, fingerprints);
  try {
    experiment(disturber);
  } catch (const Disturber::Stop&) {
  }
  return disturber.deviation();
}

/// The fields that a node has read, each with the first block where it has.
std::vector<std::pair<FieldId, BlockId>> culprits(const Deviation& deviation,
                                                  const Experiment& experiment,
                                                  const std::vector<std::size_t>& fingerprints,
                                                  const Disturbance& disturbance) {
  std::vector<std::pair<FieldId, BlockId>> found;
  Disturbance one = disturbance;
  one.node = deviation.number;
  for (one.field = 0; one.field < static_cast<FieldId>(deviation.fields.size()); ++one.field) {
    one.block = every;
    if (!deviation_under(one, experiment, fingerprints)) continue;
    for (one.block = 0; one.block < deviation.blocks; ++one.block)
      if (deviation_under(one, experiment, fingerprints)) break;
    found.emplace_back(one.field, one.block < deviation.blocks ? one.block : every);
  }
  return found;
}

}  // namespace

std::string text(const UndeclaredAccess& access) {
  const bool reads = access.kind == UndeclaredAccess::Kind::read;
  const std::string blocks =
      access.field_block < 0 ? "several blocks" : fmt::format("block {}", access.field_block);
  return fmt::format("phase {} on block {} {} {} of {} without declaring it", access.phase,
                     access.block, reads ? "reads" : "writes", access.field, blocks);
}

std::vector<UndeclaredAccess> undeclared_accesses(const Experiment& experiment) {
  Recorder recorder;
  experiment(recorder);
  std::vector<UndeclaredAccess> found = recorder.writes();
  // Where a phase writes what it has not declared, disturbing that would leave traces.
  Disturbance disturbance;
  disturbance.spared = recorder.written();
  while (const auto deviation = deviation_under(disturbance, experiment, recorder.fingerprints())) {
    const auto read = culprits(*deviation, experiment, recorder.fingerprints(), disturbance);
    for (const auto& [field, block] : read) {
      disturbance.spared.insert({deviation->phase, field});
      found.push_back({UndeclaredAccess::Kind::read, deviation->phase, deviation->block,
                       deviation->fields[static_cast<std::size_t>(field)], block});
    }
    if (!read.empty()) continue;
    // Only several fields together make a difference.
    disturbance.spared.insert({deviation->phase, every});
    found.push_back({UndeclaredAccess::Kind::read, deviation->phase, deviation->block,
                     "several fields", every});
  }
  return found;
}

}  // namespace pliant::scheduler
