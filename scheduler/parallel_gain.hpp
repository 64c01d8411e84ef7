#pragma once

namespace pliant::scheduler {

/// Whether other workers make a graph faster. Where its nodes take microseconds, waking workers and
/// handing nodes to them takes longer than they save, and keeps cores busy that others could use.
///
/// A graph is tried: it runs a few times on the calling thread alone, a few times on all workers,
/// and then for a while in the better way. The while doubles each time that the same way wins. It
/// ends early if runs on the calling thread become much longer. A graph that takes long at its
/// first run goes on all workers without a trial of them.
class ParallelGain {
 public:
  /// Whether the next run should be on all workers.
  bool is_expected() const;

  /// After a run in the expected way, which took `wall` [s].
  void record(double wall);

 private:
  void choose(bool all_workers);

  int run_ = 0;                      // since the trials began
  int stretch_ = 0;                  // runs after the trials until the next ones
  int longer_runs_ = 0;              // in a row, on the calling thread
  double alone_ = 0, together_ = 0;  // shortest times of the trials [s]
  bool is_chosen_ = false;           // to run on all workers
};

}  // namespace pliant::scheduler
