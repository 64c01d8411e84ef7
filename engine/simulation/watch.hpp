#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/case/checks/stability.hpp"
#include "engine/method/solver.hpp"
#include "engine/output/archive/archive.hpp"
#include "engine/output/summary.hpp"

namespace pliant {

/// Checks during a run what its bodies should conserve: energy except for work and damping (RP.72),
/// mass, and, if nothing acts on them, momentum and angular momentum. It checks at the same steps
/// whatever the output times are, and changes nothing.
class Watch {
 public:
  /// The place of all bodies at t = 0: the centre of their bounding box, and the radius of gyration
  /// of the box as a solid of uniform density [m].
  struct Middle {
    Vector centre = {};
    double radius = 0;
  };

  explicit Watch(const Case& settings);

  /// Takes the state at t = 0 as the reference.
  void begin(Solver& solver);

  /// Checks when it is due, or at the `last` step. Returns a warning to show, or an empty string.
  /// Throws StepFailure if the case asks for it, and if the energy is no longer credible.
  std::string observe(Solver& solver, bool last);

  SummaryChecks report() const;

  void put(ArchiveWriter& archive) const;
  void get(const ArchiveReader& archive);

 private:
  /// Largest relative change so far of a conserved quantity, and its time.
  struct Excess {
    double share = 0, time = 0, warned = 0;
  };
  void look(Solver& solver);
  /// What is wrong at present, and what to do about it.
  std::vector<std::string> verdicts(const Solver& solver, bool last);
  std::string judge(Excess Watch::*excess, CheckResponse response, const Solver& solver,
                    const std::string& what, const std::string& remedy);
  std::string judge_number(const Solver& solver, bool last) const;
  std::string judge_loss() const;
  std::string judge_rest(const Solver& solver, bool last) const;
  /// Mean strain of the bodies at a strain energy [J].
  double strain_of(double energy) const;
  /// That of now.
  double strain() const;
  std::string judge_slow_load(const Solver& solver) const;
  std::string judge_linear_law() const;
  std::string judge_damping(const Solver& solver) const;
  std::string judge_precision() const;
  /// Spurious energy of bodies at rest from rounding [J].
  double rounding_energy() const;
  void look_at_momentum(const Solver& solver);
  std::array<double*, 27> numbers();

  const Case& settings_;
  double mass_scaling_;  ///< in momenta and kinetic energy
  Middle middle_;
  ConservedQuantities start_, present_;
  EnergyBudget budget_;
  double created_ = 0, scale_ = 0, momentum_scale_ = 0, angular_scale_ = 0;
  double is_known_ = 0;                        ///< whether the method accounts for work
  double looked_at_ = 0, damped_by_then_ = 0;  ///< time [s], and loss by damping until then [J]
  double damping_power_ = 0;                   ///< mean since the look before [W]
  Excess energy_, mass_, momentum_, angular_momentum_;
};

/// Conserved quantities as the summary shows them.
ConservedQuantities conserved(const BodyIntegrals& sum);

}  // namespace pliant
