#include "scheduler/exchanges.hpp"

#include <map>
#include <utility>

namespace pliant::scheduler {

namespace {

/// The values of other blocks that every process knows at this place of the list, for each field.
class KnownValues {
 public:
  bool has(const Access& read) const {
    const auto found = reach_.find(read.field);
    return read.reach <= (found == reach_.end() ? Reach::own : found->second);
  }
  void add(const Access& read) {
    if (!has(read)) reach_[read.field] = read.reach;
  }

  void follow(const Phase& phase) {
    if (phase.kind == Phase::Kind::exchange) {
      for (const Access& read : phase.reads) add(read);
    }
    for (const Access& write : phase.writes)
      reach_[write.field] = phase.kind == Phase::Kind::reduce ? Reach::all : Reach::own;
  }

 private:
  std::map<FieldId, Reach> reach_;
};

}  // namespace

std::vector<Phase> with_exchanges(std::vector<Phase> phases) {
  KnownValues known;
  std::vector<Phase> result;
  for (Phase& phase : phases) {
    Phase exchange = {
        .name = "exchange", .stage = phase.stage, .kind = Phase::Kind::exchange, .run = {}};
    if (phase.kind == Phase::Kind::per_block) {
      for (const Access& read : phase.reads) {
        if (known.has(read)) continue;
        exchange.reads.push_back(read);
        known.add(read);
      }
    }
    known.follow(phase);
    if (!exchange.reads.empty()) result.push_back(std::move(exchange));
    result.push_back(std::move(phase));
  }
  return result;
}

}  // namespace pliant::scheduler
