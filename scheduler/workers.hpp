#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

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

  /// Calls f(i) for i = 0..count-1, in parallel and in any order: for work outside steps. Throws
  /// what f throws.
  template <class F>
  void for_each(int count, F&& f) {
    using Call = std::remove_reference_t<F>;
    loop(
        count, [](void* what, int i) { (*static_cast<Call*>(what))(i); }, &f);
  }

  /// The sum of f(i) over i = 0..count-1, which the function add(sum, part) of the type `Sum` adds
  /// up in this order, so that it does not depend on the number of threads.
  template <class Sum, class F>
  Sum sum(int count, F&& f) {
    std::vector<Sum> parts(static_cast<std::size_t>(count));
    for_each(count, [&](int i) { parts[static_cast<std::size_t>(i)] = f(i); });
    Sum sum = {};
    for (const Sum& part : parts) add(sum, part);
    return sum;
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
  void loop(int count, void (*function)(void*, int), void* what);

  int threads_;
  std::uint64_t id_;
  std::unique_ptr<Arena> arena_;
  NodeRunner* runner_ = nullptr;
};

}  // namespace pliant::scheduler
