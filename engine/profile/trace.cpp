#include "engine/profile/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "engine/output/error.hpp"

// Chrome's "Trace Event Format": events with times in microseconds, on tracks given by `tid`.
// Events of one track nest by their times.
namespace pliant::profile {

namespace {

constexpr int frame_track = 1, step_track = 2, first_worker_track = 3;

std::string name_of_track(int track, const std::string& name) {
  return fmt::format(R"({{"name":"thread_name","ph":"M","pid":1,"tid":{},"args":{{"name":"{}"}}}})"
                     ",\n",
                     track, name);
}

std::string event(int track, std::string_view name, double start, double seconds,
                  std::string_view arguments) {
  return fmt::format(
      R"({{"name":"{}","ph":"X","pid":1,"tid":{},"ts":{:.2f},"dur":{:.2f},"args":{{{}}}}})"
      ",\n",
      name, track, 1e6 * start, 1e6 * seconds, arguments);
}

}  // namespace

TraceWriter::TraceWriter(const std::filesystem::path& path, int threads)
    : path_(path), file_(path), stream_(std::fopen(file_.path().c_str(), "we"), &std::fclose) {
  if (!stream_) throw OutputError::system(path_, "open it", errno);
  write("[\n" + name_of_track(frame_track, "frames") + name_of_track(step_track, "steps"));
  for (int worker = 0; worker < threads; ++worker) {
    write(name_of_track(first_worker_track + worker, fmt::format("thread {}", worker)));
  }
}

double TraceWriter::since_start(Clock::time_point time) const {
  return std::chrono::duration<double>(time - start_).count();
}

int TraceWriter::label_of(const scheduler::Phase& phase) {
  const auto [entry, is_new] =
      label_numbers_.try_emplace(label(phase), static_cast<int>(labels_.size()));
  if (is_new) labels_.push_back(entry->first);
  return entry->second;
}

void TraceWriter::add(const scheduler::StepGraph& graph) {
  label_of_phase_.clear();
  label_of_phase_.reserve(graph.phases().size());
  for (const scheduler::Phase& phase : graph.phases()) label_of_phase_.push_back(label_of(phase));
  const double start = since_start(graph.record().start);
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    const scheduler::Node& node = graph.nodes()[n];
    if (node.is_junction()) continue;
    const scheduler::Span& span = graph.record().spans[n];
    events_.push_back({start + span.start, span.stop - span.start, span.worker,
                       label_of_phase_[static_cast<std::size_t>(node.phase)], node.block});
  }
}

void TraceWriter::end_step(Clock::time_point start, double seconds, double simulated_time) {
  const std::size_t count = events_.size() - first_event_;
  const std::size_t kept = std::min(count, most_nodes);
  if (kept < count) {
    const auto first = events_.begin() + static_cast<std::ptrdiff_t>(first_event_);
    const auto end = first + static_cast<std::ptrdiff_t>(kept);
    std::nth_element(first, end, events_.end(),
                     [](const Event& a, const Event& b) { return a.seconds > b.seconds; });
    events_.erase(end, events_.end());
  }
  steps_.push_back({since_start(start), seconds, simulated_time, kept, count - kept});
  first_event_ = events_.size();
}

void TraceWriter::end_frame(Clock::time_point start, double seconds, double simulated_time) {
  std::string text = event(frame_track, "frame", since_start(start), seconds,
                           fmt::format(R"("simulated_time":{:.9g})", simulated_time));
  auto next = events_.begin();
  for (const Step& step : steps_) {
    std::string arguments = fmt::format(R"("simulated_time":{:.9g})", step.simulated_time);
    if (step.left_out > 0)
      arguments += fmt::format(R"(,"shorter_nodes_left_out":{})", step.left_out);
    text += event(step_track, "step", step.start, step.seconds, arguments);
    const auto end = next + static_cast<std::ptrdiff_t>(step.nodes);
    for (; next != end; ++next) {
      text +=
          event(first_worker_track + next->worker, labels_[static_cast<std::size_t>(next->label)],
                next->start, next->seconds, fmt::format(R"("block":{})", next->block));
    }
  }
  write(text);
  events_.clear();
  steps_.clear();
  first_event_ = 0;
}

void TraceWriter::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size()) {
    throw OutputError::system(path_, "write it", errno);
  }
}

void TraceWriter::publish() {
  write(R"({"name":"end","ph":"i","s":"g","pid":1,"tid":1,"ts":)" +
        fmt::format("{:.2f}}}\n]\n", 1e6 * since_start(Clock::now())));
  if (std::fflush(stream_.get()) != 0) throw OutputError::system(path_, "write it", errno);
  file_.publish(Durable::no);
}

}  // namespace pliant::profile
