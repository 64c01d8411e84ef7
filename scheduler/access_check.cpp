#include "scheduler/access_check.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "scheduler/access_probes.hpp"

// Two kinds of probes observe the same experiment.
//
//     recorder   records what each node writes, and compares all other memory before and after it
//     disturber  changes all values that a node has not declared while it runs, and stops at the
//                first node whose writes differ from the record
//
// To find the phase and the field that cause a difference, the check disturbs one phase at a time,
// then one field of it, then one block of that. The phase is that of the node that differs, or an
// earlier one that kept what it read in memory of no field. Each access found is excluded, and the
// disturber starts again until nothing differs any more.
namespace pliant::scheduler {

namespace {

using Experiment = std::function<void(AccessProbe&)>;

class Search {
 public:
  explicit Search(const Experiment& experiment) : experiment_(experiment) {
    experiment(recorder_);
    found_ = recorder_.writes();
    // Values that a phase writes without declaring them are not disturbed, since that would leave
    // traces.
    disturbance_.spared = recorder_.written();
  }

  std::vector<UndeclaredAccess> run() {
    while (const auto deviation = deviation_under(disturbance_)) {
      if (find_reads(*deviation)) continue;
      if (disturbance_.spared.count({deviation->phase, every}) != 0) break;
      spare(deviation->phase, every, *deviation);
    }
    return std::move(found_);
  }

 private:
  std::optional<Deviation> deviation_under(const Disturbance& disturbance) const {
    Disturber disturber(disturbance, recorder_.nodes());
    try {
      experiment_(disturber);
    } catch (const Disturber::Stop&) {
    }
    return disturber.deviation();
  }

  bool find_reads(const Deviation& deviation) {
    if (find_reads_of(deviation.phase, deviation)) return true;
    std::set<std::string> tried = {deviation.phase};
    for (std::size_t n = deviation.number; n-- > 0;) {
      const std::string& phase = recorder_.nodes()[n].phase;
      if (tried.insert(phase).second && find_reads_of(phase, deviation)) return true;
    }
    return false;
  }

  bool find_reads_of(const std::string& phase, const Deviation& deviation) {
    Disturbance one = disturbance_;
    one.phase = phase;
    one.last_node = deviation.number;
    if (!deviation_under(one)) return false;
    bool any = false;
    for (one.field = 0; one.field < static_cast<FieldId>(deviation.fields.size()); ++one.field) {
      if (const auto read = deviation_under(one)) {
        spare(phase, one.field, *read, block_of(one, *read));
        any = true;
      }
    }
    return any;
  }

  // The first block whose values alone cause a difference.
  BlockId block_of(Disturbance one, const Deviation& deviation) const {
    for (one.block = 0; one.block < deviation.blocks; ++one.block)
      if (deviation_under(one)) return one.block;
    return every;
  }

  void spare(const std::string& phase, FieldId field, const Deviation& deviation,
             BlockId field_block = every) {
    disturbance_.spared.insert({phase, field});
    found_.push_back(
        {UndeclaredAccess::Kind::read, phase, deviation.phase == phase ? deviation.block : every,
         field == every ? "several fields" : deviation.fields[static_cast<std::size_t>(field)],
         field_block});
  }

  const Experiment& experiment_;
  Recorder recorder_;
  Disturbance disturbance_;
  std::vector<UndeclaredAccess> found_;
};

}  // namespace

std::string text(const UndeclaredAccess& access) {
  const auto of = [](const char* before, BlockId block, const char* otherwise) {
    return block < 0 ? std::string(otherwise) : fmt::format("{} block {}", before, block);
  };
  return fmt::format("phase {}{} {} {}{} without declaring it", access.phase,
                     of(" on", access.block, ""),
                     access.kind == UndeclaredAccess::Kind::read ? "reads" : "writes", access.field,
                     of(" of", access.field_block, " of several blocks"));
}

std::vector<UndeclaredAccess> undeclared_accesses(const Experiment& experiment) {
  return Search(experiment).run();
}

}  // namespace pliant::scheduler
