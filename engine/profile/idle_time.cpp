#include "engine/profile/idle_time.hpp"

#include <algorithm>

namespace pliant::profile {

// Edges are sorted by the node that they lead to, and always lead to later nodes, so one pass finds
// all predecessors of every node. A junction does no work: it ends when it is ready.
void IdleTimeSplitter::add(const scheduler::StepGraph& graph) {
  const auto& nodes = graph.nodes();
  const auto& spans = graph.record().spans;
  ready_.assign(nodes.size(), 0);
  for (const scheduler::Edge& edge : graph.edges()) {
    const auto from = static_cast<std::size_t>(edge.from);
    const double end = nodes[from].is_junction() ? ready_[from] : spans[from].stop;
    double& ready = ready_[static_cast<std::size_t>(edge.to)];
    ready = std::max(ready, end);
  }
  const std::size_t before = works_.size();
  works_.reserve(before + nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].is_junction()) continue;
    works_.push_back({spans[n].worker, ready_[n], spans[n].start, spans[n].stop});
  }
  runs_.push_back({works_.size() - before, graph.record().wall_seconds,
                   static_cast<int>(graph.record().worker_busy_seconds.size())});
}

IdleTime IdleTimeSplitter::take() {
  IdleTime sum;
  Work* first = works_.data();
  for (const Run& run : runs_) {
    std::sort(first, first + run.nodes, [](const Work& a, const Work& b) {
      return a.worker != b.worker ? a.worker < b.worker : a.start < b.start;
    });
    const IdleTime idle = split(run, first);
    sum.waiting += idle.waiting;
    sum.scheduling += idle.scheduling;
    first += run.nodes;
  }
  works_.clear();
  runs_.clear();
  return sum;
}

// `works` must be sorted by worker, then by start.
IdleTime IdleTimeSplitter::split(const Run& run, const Work* works) {
  const Work* const stop = works + run.nodes;
  double end = 0;
  for (const Work* work = works; work != stop; ++work) end = std::max(end, work->stop);
  IdleTime idle;
  const Work* next = works;
  for (int worker = 0; worker < run.workers; ++worker) {
    double last = 0;
    for (; next != stop && next->worker == worker; ++next) {
      const double gap = next->start - last;
      const double waiting = std::clamp(next->ready - last, 0.0, std::max(gap, 0.0));
      idle.waiting += waiting;
      idle.scheduling += gap - waiting;
      last = next->stop;
    }
    idle.waiting += end - last;
    idle.scheduling += run.wall_seconds - end;
  }
  return idle;
}

}  // namespace pliant::profile
