#pragma once

#include <memory>
#include <optional>

#include "engine/method/solver.hpp"
#include "engine/undeformed/body.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::undeformed {

/// What the solvers of all methods on the undeformed body do alike. A step always has its full
/// length, so that no output time alters a run: a short step now and then would feed vibrations.
/// Where an output time lies inside a step, particles are shown on their straight way through it.
template <class T, int D>
class Solver : public pliant::Solver {
 public:
  using pliant::Solver::Solver;

  const Clock& clock() const override { return shared().clock; }
  std::int64_t particles() const override;
  std::optional<EnergyBudget> energy_budget() const override;
  Balance balance() override;
  Loads& loads() override { return shared().boundaries; }
  std::vector<FieldView> fields(int body) const override;
  const scheduler::StepGraph& step_graph() const override { return *graph_; }
  scheduler::StepGraph& step_graph() { return *graph_; }

 protected:
  std::unique_ptr<scheduler::StepGraph> graph_;

 private:
  virtual State<D>& shared() = 0;
  virtual const State<D>& shared() const = 0;
  virtual int body_count() const = 0;
  virtual Body<T, D>& body(int number) = 0;
  virtual const Body<T, D>& body(int number) const = 0;

  /// Takes a whole step, and leaves its length and its end in the clock.
  virtual void begin_step() = 0;
  /// The time of the clock has changed.
  virtual void show() {}

  void take_step(double time_step) override;
  void store_end();
  void move_to_output();
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::undeformed
