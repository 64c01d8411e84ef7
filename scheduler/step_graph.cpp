#include "scheduler/step_graph.hpp"

#include <tbb/flow_graph.h>

#include <algorithm>
#include <deque>
#include <random>
#include <utility>

#include "scheduler/chains.hpp"
#include "scheduler/exchanges.hpp"
#include "scheduler/node_runner.hpp"
#include "scheduler/zero_subnormals.hpp"

namespace pliant::scheduler {

namespace {

constexpr int no_timer = -1;

// Nodes of a graph that takes long on one thread, so that there is no need to try.
constexpr std::size_t large_graph = 1000;

double seconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void StepGraph::Task::operator()(int on_worker) {
  worker = on_worker;
  start = Clock::now();
  (*run)(block);
  stop = Clock::now();
}

// The oneTBB graph, with one node for each chain. It belongs to the arena in which it was made, and
// so to one set of workers.
struct StepGraph::Flow {
  using Message = tbb::flow::continue_msg;
  using FlowNode = tbb::flow::continue_node<Message>;

  Flow(const Dependencies& dependencies, std::vector<Task>& tasks, std::uint64_t workers)
      : workers_id(workers) {
    const auto heads = chain_heads(dependencies);
    std::vector<FlowNode*> flow_node(tasks.size());
    std::vector<Task*> chain_end(tasks.size());
    for (std::size_t n = 0; n < tasks.size(); ++n) {
      const auto head = static_cast<std::size_t>(heads[n]);
      if (head == n)
        flow_node[n] = &add_node(dependencies.nodes[n].is_junction() ? nullptr : &tasks[n]);
      else
        chain_end[head]->next = &tasks[n];
      chain_end[head] = &tasks[n];
      tasks[n].next = nullptr;
    }

    std::vector<std::pair<int, int>> links;
    for (const Edge& edge : dependencies.edges)
      links.emplace_back(heads[static_cast<std::size_t>(edge.from)],
                         heads[static_cast<std::size_t>(edge.to)]);
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    std::vector<bool> has_predecessor(tasks.size());
    for (const auto& [from, to] : links) {
      if (from == to) continue;
      make_edge(*flow_node[static_cast<std::size_t>(from)],
                *flow_node[static_cast<std::size_t>(to)]);
      has_predecessor[static_cast<std::size_t>(to)] = true;
    }
    for (std::size_t n = 0; n < tasks.size(); ++n)
      if (flow_node[n] != nullptr && !has_predecessor[n]) sources.push_back(flow_node[n]);
  }

  FlowNode& add_node(Task* first_of_chain) {
    return nodes.emplace_back(graph, [first_of_chain](const Message&) {
      const ZeroSubnormals arithmetic;
      for (Task* task = first_of_chain; task != nullptr; task = task->next)
        (*task)(tbb::this_task_arena::current_thread_index());
    });
  }

  void run() {
    for (FlowNode* source : sources) source->try_put(Message());
    graph.wait_for_all();
  }

  std::uint64_t workers_id;
  tbb::flow::graph graph;
  std::deque<FlowNode> nodes;
  std::vector<FlowNode*> sources;
};

StepGraph::StepGraph(std::vector<Phase> phases, Blocks blocks, std::vector<std::string> field_names)
    : phases_(with_exchanges(std::move(phases))),
      blocks_(std::move(blocks)),
      field_names_(std::move(field_names)),
      dependencies_(derive_dependencies(phases_, blocks_, field_names_)) {
  name_timers();
  tasks_.reserve(nodes().size());
  for (const Node& node : nodes())
    tasks_.push_back(
        {&phases_[static_cast<std::size_t>(node.phase)].run, node.block, 0, {}, {}, nullptr});
  record_.phase_seconds.resize(timer_names_.size());
  record_.block_seconds.resize(timer_names_.size() *
                               static_cast<std::size_t>(std::max(blocks_.count(), 1)));
  record_.spans.resize(tasks_.size());
}

StepGraph::StepGraph(StepGraph&&) noexcept = default;
StepGraph& StepGraph::operator=(StepGraph&&) noexcept = default;
StepGraph::~StepGraph() = default;

void StepGraph::name_timers() {
  for (const Phase& phase : phases_) {
    if (phase.kind == Phase::Kind::exchange) {
      timer_of_phase_.push_back(no_timer);
      continue;
    }
    const auto found = std::find(timer_names_.begin(), timer_names_.end(), phase.name);
    timer_of_phase_.push_back(static_cast<int>(found - timer_names_.begin()));
    if (found == timer_names_.end()) timer_names_.push_back(phase.name);
  }
}

void StepGraph::run(Workers& workers) {
  if (NodeRunner* runner = workers.delegate())
    return workers.execute([&] { run_through(*runner); });
  workers.execute([&] { run_on(workers); });
}

// The nodes of one block wait for each other. Other workers would wake for nothing.
void StepGraph::run_on(const Workers& workers) {
  const bool has_several_blocks = blocks_.count() > 1;
  const bool is_tried = has_several_blocks && tasks_.size() <= large_graph;
  const bool on_all_workers = is_tried ? gain_.is_expected() : has_several_blocks;
  const auto start = Clock::now();
  on_all_workers ? run_in_parallel(workers) : run_in_order(workers.index());
  finish_record(start, workers.threads());
  if (is_tried) gain_.record(record_.wall_seconds);
}

void StepGraph::run_in_parallel(const Workers& workers) {
  if (!flow_ || flow_->workers_id != workers.id())
    flow_ = std::make_unique<Flow>(dependencies_, tasks_, workers.id());
  try {
    flow_->run();
  } catch (...) {
    flow_.reset();  // it may hold messages of the cancelled step
    throw;
  }
}

void StepGraph::run_in_order(int worker) {
  const ZeroSubnormals arithmetic;
  for (std::size_t n = 0; n < nodes().size(); ++n)
    if (!nodes()[n].is_junction()) tasks_[n](worker);
}

void StepGraph::run_through(NodeRunner& runner) {
  const ZeroSubnormals arithmetic;
  const auto start = Clock::now();
  for (std::size_t n = 0; n < nodes().size(); ++n) {
    if (nodes()[n].is_junction()) continue;
    tasks_[n].worker = 0;
    tasks_[n].start = Clock::now();
    runner.run(*this, nodes()[n]);
    tasks_[n].stop = Clock::now();
  }
  finish_record(start, 1);
}

void StepGraph::run_serially(std::uint64_t seed) {
  const ZeroSubnormals arithmetic;
  std::mt19937_64 random(seed);
  std::vector<int> waits_for(nodes().size()), ready;
  std::vector<std::vector<int>> successors(nodes().size());
  for (const Edge& edge : edges()) {
    ++waits_for[static_cast<std::size_t>(edge.to)];
    successors[static_cast<std::size_t>(edge.from)].push_back(edge.to);
  }
  for (std::size_t n = 0; n < nodes().size(); ++n)
    if (waits_for[n] == 0) ready.push_back(static_cast<int>(n));

  const auto start = Clock::now();
  while (!ready.empty()) {
    std::swap(ready[random() % ready.size()], ready.back());
    const auto n = static_cast<std::size_t>(ready.back());
    ready.pop_back();
    if (!nodes()[n].is_junction()) tasks_[n](0);
    for (const int next : successors[n])
      if (--waits_for[static_cast<std::size_t>(next)] == 0) ready.push_back(next);
  }
  finish_record(start, 1);
}

void StepGraph::finish_record(Clock::time_point start, int workers) {
  record_.wall_seconds = seconds(Clock::now() - start);
  record_.start = start;
  std::fill(record_.phase_seconds.begin(), record_.phase_seconds.end(), 0.0);
  std::fill(record_.block_seconds.begin(), record_.block_seconds.end(), 0.0);
  record_.worker_busy_seconds.assign(static_cast<std::size_t>(workers), 0.0);
  const std::size_t row = static_cast<std::size_t>(std::max(blocks_.count(), 1));
  for (std::size_t n = 0; n < tasks_.size(); ++n) {
    const Task& task = tasks_[n];
    if (nodes()[n].is_junction()) continue;
    const double duration = seconds(task.stop - task.start);
    const auto timer =
        static_cast<std::size_t>(timer_of_phase_[static_cast<std::size_t>(nodes()[n].phase)]);
    record_.phase_seconds[timer] += duration;
    record_.block_seconds[timer * row + static_cast<std::size_t>(task.block)] += duration;
    record_.worker_busy_seconds[static_cast<std::size_t>(task.worker)] += duration;
    record_.spans[n] = {seconds(task.start - start), seconds(task.stop - start), task.worker};
  }
}

}  // namespace pliant::scheduler
