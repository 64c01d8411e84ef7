#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <pliant/case_file.hpp>
#include <pliant/field.hpp>
#include <pliant/input.hpp>

namespace pliant {

/// How to compute. No option changes a result, not even by a bit.
struct SimulationOptions {
  int threads = 0;  ///< 0: one for each processor
  std::string isa;  ///< "sse2", "avx2" or "avx512"; empty: the widest that the processor has
};

/// Conserved quantities of all bodies, in SI units, per unit thickness in 2D.
struct Totals {
  double mass;
  std::array<double, 3> momentum, angular_momentum;  ///< about the origin
  double kinetic_energy, strain_energy;
};

/// How far an advance within a wall-time budget has come.
struct Progress {
  std::int64_t steps = 0;
  double lag = 0;        ///< simulated time still missing: the requested time minus `time` [s]
  double wall_time = 0;  ///< wall time of the call [s]
};

/// A simulation of a case that the caller advances.
///
///     pliant::Simulation simulation(pliant::CaseFile::read("cases/bouncing_ball"));
///     while (simulation.time() < 0.2) {
///       simulation.advance(simulation.time() + 1. / 60);
///       std::cout << simulation.measurement("height") << '\n';
///     }
///
/// Not safe for use by several threads at once; it runs its own `threads`. Spans that it returns
/// are valid until the next call that is not const. All values are in SI units; vectors have three
/// components, the third zero in 2D.
class Simulation {
 public:
  /// Checks the case and sets it up. Throws InputError for errors in the case, RunError when the
  /// set-up fails.
  explicit Simulation(const CaseFile& case_file, const SimulationOptions& options = {});
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Takes one time step of the length that the case requests. Throws RunError.
  void step();
  /// Steps until the time is `until` [s]; the last step is shortened to end there. Throws RunError.
  void advance(double until);
  /// The same within `budget` seconds of wall time. Stops before a step that would probably exceed
  /// the budget, but takes at least one step. Throws RunError.
  Progress advance(double until, double budget);

  double time() const;              ///< [s]
  double time_step() const;         ///< length of the next step [s]
  std::int64_t step_count() const;  ///< since t = 0
  int dimension() const;            ///< 2 or 3

  const std::vector<std::string>& bodies() const;  ///< names, in the order of the case
  std::int64_t particle_count() const;             ///< of all bodies

  /// The runs of slots that hold the particles of a body, in ascending order.
  std::vector<SlotRun> particles(int body) const;
  /// All fields of a body, without a copy.
  std::vector<FieldView> fields(int body) const;
  /// One field of a body, without a copy. Throws InputError for an unknown name; the message lists
  /// the fields.
  FieldView field(int body, std::string_view name) const;
  /// Positions of the particles of a body [m], in the order of `particles`. They are a copy, since
  /// bodies store positions relative to their lattices.
  std::vector<std::array<double, 3>> positions(int body) const;

  Totals totals();
  /// The present value of a measurement of the case. A force is its mean since the last call.
  /// Throws InputError for an unknown name, and for a measurement that evaluates the history of
  /// another one (a period, say): the caller has to record that history.
  double measurement(std::string_view name);

  /// Sets the pressure [Pa] of a boundary of kind "pressure"; it replaces that of the case.
  void set_pressure(std::string_view boundary, double pressure);
  /// Sets the velocity of a wall [m/s]; it replaces the motion of the case.
  void set_wall_velocity(std::string_view boundary, const std::array<double, 3>& velocity);

  /// Moves the blade of a cut; from then on the motion of the case no longer applies. `from` and
  /// `to` are the ends of its edge in the deformed body [m]; in 2D the edge is the point `from`.
  /// The tissue that the edge sweeps between two calls is cut. Throws InputError for methods
  /// without cuts.
  void move_blade(std::string_view cut, const std::array<double, 3>& from,
                  const std::array<double, 3>& to);
  /// Takes a blade out at its place in the last step; the next `move_blade` begins a new cut.
  void lift_blade(std::string_view cut);
  /// Force of the blade of a cut on its body in the last step [N], per unit thickness in 2D. A hand
  /// that holds the blade feels the opposite force. It is zero if the cut has no resistance,
  /// friction or drag.
  std::array<double, 3> blade_force(std::string_view cut) const;

  /// Applies an input at its time: at once if that time has passed, else in the advance that
  /// reaches it; a step then ends there. Throws InputError for names that are not in the case.
  void enter(const Input& input);
  /// Applies the inputs of a session in order and advances to the time of each. If the session was
  /// recorded from the same state, the results are bitwise the same.
  void play(const std::vector<Input>& session);
  /// All inputs of this simulation since it was made or restored.
  const std::vector<Input>& session() const;

  /// Writes the whole state, with loads that were set but without inputs for later times. Throws
  /// RunError.
  void save(const std::filesystem::path& file) const;
  /// Restores a state that a simulation of the same case has saved, and continues bitwise. Throws
  /// InputError when the file is of another case, RunError when it cannot be read.
  void restore(const std::filesystem::path& file);

 private:
  int checked(int body) const;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
