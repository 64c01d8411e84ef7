#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstdint>
#include <utility>

namespace pliant::scheduler {

class NodeRunner;

/// The threads that run steps: the calling thread and `threads - 1` others, which exist only from
/// the first parallel work on. With one thread nothing ever runs elsewhere than on the caller.
class Workers {
 public:
  /// Throws std::invalid_argument unless threads is positive.
  explicit Workers(int threads);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return threads_; }

  /// Calls `f` on the calling thread as one of the workers. Around a loop over steps it saves each
  /// step the way in and out.
  template <class F>
  void execute(F&& f) {
    arena_.execute(std::forward<F>(f));
  }

  /// Of the calling worker, 0..threads-1; only for calls from within `execute` or a step.
  int index() const { return tbb::this_task_arena::current_thread_index(); }

  /// Has `runner` run the nodes of all graphs, on the calling thread; nullptr: as usual.
  void delegate(NodeRunner* runner) { runner_ = runner; }
  NodeRunner* delegate() const { return runner_; }

  /// Differs between any two Workers of this process.
  std::uint64_t id() const { return id_; }

 private:
  int threads_;
  std::uint64_t id_;
  // Lets oneTBB start more threads than there are cores, where so many are asked for.
  tbb::global_control limit_;
  tbb::task_arena arena_;
  NodeRunner* runner_ = nullptr;
};

}  // namespace pliant::scheduler
