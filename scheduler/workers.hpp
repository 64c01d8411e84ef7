#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>

namespace pliant::scheduler {

class NodeRunner;

/// The threads that run steps: the calling thread and `threads - 1` others, which start with the
/// first parallel work. With one thread everything runs on the caller.
class Workers {
 public:
  /// Throws std::invalid_argument unless threads is positive.
  explicit Workers(int threads);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  int threads() const { return threads_; }

  /// Calls `f` on the calling thread as one of the workers. Around a loop over steps, it saves
  /// entering and leaving the arena in each step.
  template <class F>
  void execute(F&& f) {
    using Call = std::remove_reference_t<F>;
    call([](void* what) { (*static_cast<Call*>(what))(); }, &f);
  }

  /// Number of the calling worker, 0..threads-1; only for calls inside `execute` or a step.
  int index() const;

  /// Lets `runner` run the nodes of all graphs on the calling thread; nullptr: back to the workers.
  void delegate(NodeRunner* runner) { runner_ = runner; }
  NodeRunner* delegate() const { return runner_; }

  /// Differs between any two Workers of this process.
  std::uint64_t id() const { return id_; }

 private:
  // The headers of oneTBB take longer to compile than most files that include this one.
  struct Arena;

  void call(void (*function)(void*), void* what);

  int threads_;
  std::uint64_t id_;
  std::unique_ptr<Arena> arena_;
  NodeRunner* runner_ = nullptr;
};

}  // namespace pliant::scheduler
