#pragma once

#include <memory>

#include "engine/method/blades.hpp"
#include "engine/point_based/body_cuts.hpp"
#include "engine/point_based/step.hpp"
#include "engine/undeformed/solver.hpp"

namespace pliant::point_based {

/// Advances a case by the point-based method.
template <class T, int D>
class Solver final : public undeformed::Solver<T, D>, public Blades {
 public:
  /// Throws InputError for bodies that hold no nodes.
  Solver(const Case& settings, const SolverOptions& options);

  /// What is left of a step that an output time divides, else (PB.12).
  double time_step() const override;
  std::size_t bytes() const override;

  BodyIntegrals integrals() override;
  /// Of the leapfrog without stiffness-proportional damping, whose velocities belong to the time of
  /// the displacements and whose losses are known.
  std::optional<EnergyBudget> energy_budget() const override;
  Frame frame(const FrameParts& parts) override;

  void put_blade(std::size_t cut, const std::array<double, 3>& from,
                 const std::array<double, 3>& to) override;
  void lift_blade(std::size_t cut) override;
  std::array<double, 3> blade_force(std::size_t cut) const override;

  std::vector<SlotRun> particle_runs(int body) const override;
  std::vector<std::array<double, 3>> positions(int body) const override;

  State<T, D>& state() { return state_; }
  const State<T, D>& state() const { return state_; }

 private:
  using Base = undeformed::Solver<T, D>;

  State<T, D>& shared() override { return state_; }
  const State<T, D>& shared() const override { return state_; }
  int body_count() const override { return static_cast<int>(state_.bodies.size()); }
  Body<T, D>& body(int number) override { return state_.bodies.at(number); }
  const Body<T, D>& body(int number) const override { return state_.bodies.at(number); }
  void begin_step() override;
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  void check(const StepResult& result) const;
  /// What blades have cut so far, of each body.
  std::vector<std::span<const CutSurface<D>>> cut_surfaces() const;

  State<T, D> state_;
  typename Step<T, D>::Cuts cuts_;
  Step<T, D> step_;
  double resolution_;  ///< the least H of all bodies [m]
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::point_based
