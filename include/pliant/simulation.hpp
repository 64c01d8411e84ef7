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

/// How to compute: nothing here changes a result, which is the same to the bit.
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

/// How far an advance on a budget has come.
struct Progress {
  std::int64_t steps = 0;
  double lag = 0;        ///< simulated time that is missing: the requested time less `time` [s]
  double wall_time = 0;  ///< of the call [s]
};

/// A case that is being simulated, step by step, under the control of the caller.
///
///     pliant::Simulation simulation(pliant::CaseFile::read("cases/bouncing_ball"));
///     while (simulation.time() < 0.2) {
///       simulation.advance(simulation.time() + 1. / 60);
///       std::cout << simulation.measurement("height") << '\n';
///     }
///
/// Not safe for use by several threads at once; it uses `threads` of its own. Spans that it
/// returns are valid until the next call that is not const. All values are in SI units; vectors
/// have three components, the third zero in 2D.
class Simulation {
 public:
  /// Checks the case and sets it up. Throws InputError for what is wrong with it, RunError when it
  /// cannot be set up.
  explicit Simulation(const CaseFile& case_file, const SimulationOptions& options = {});
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// One time step of the length that the case asks for. Throws RunError.
  void step();
  /// Steps until `time` [s] is reached; the last step is shortened to end there. Throws RunError.
  void advance(double until);
  /// The same within `budget` seconds of wall time: stops before a step that would probably exceed
  /// them, and returns the simulated time that is missing. Takes at least one step. Throws
  /// RunError.
  Progress advance(double until, double budget);

  double time() const;              ///< [s]
  double time_step() const;         ///< length of the next step [s]
  std::int64_t step_count() const;  ///< since t = 0
  int dimension() const;            ///< 2 or 3

  const std::vector<std::string>& bodies() const;  ///< names, in the order of the case
  std::int64_t particle_count() const;             ///< of all bodies

  /// Where the particles of a body are in its arrays, in ascending order.
  std::vector<SlotRun> particles(int body) const;
  /// All fields of a body, without a copy.
  std::vector<FieldView> fields(int body) const;
  /// One field of a body, without a copy. Throws InputError for an unknown name, with those that
  /// exist.
  FieldView field(int body, std::string_view name) const;
  /// Positions of the particles of a body [m], in the order of `particles`: a copy, since bodies
  /// keep places relative to their lattices.
  std::vector<std::array<double, 3>> positions(int body) const;

  Totals totals();
  /// The present value of a measurement of the case; a force is the mean since it was last asked
  /// for. Throws InputError for an unknown name, and for a measurement that reads the history of
  /// another (a period, say): the caller has to keep that history.
  double measurement(std::string_view name);

  /// From now on a boundary of kind "pressure" has this pressure [Pa], whatever the case says.
  void set_pressure(std::string_view boundary, double pressure);
  /// From now on a wall moves with this velocity [m/s], whatever the case says.
  void set_wall_velocity(std::string_view boundary, const std::array<double, 3>& velocity);

  /// From now on the caller moves the blade of a cut, whatever the case says: its edge goes from
  /// one point of the deformed body to another [m]; in 2D it is the first point. The tissue that it
  /// sweeps between two calls is cut. Throws InputError for methods without cuts.
  void move_blade(std::string_view cut, const std::array<double, 3>& from,
                  const std::array<double, 3>& to);
  /// Takes a blade out, from where it was in the last step; the next `move_blade` begins a new cut.
  void lift_blade(std::string_view cut);
  /// Force of the blade of a cut on its body in the last step [N], per unit thickness in 2D; a hand
  /// that holds the blade feels the opposite force. Zero where the cut has no resistance, friction
  /// or drag.
  std::array<double, 3> blade_force(std::string_view cut) const;

  /// Applies an input at its time: at once if that has passed, else in the advance that reaches it,
  /// which ends a step there. Throws InputError for names that the case does not have.
  void enter(const Input& input);
  /// Applies the inputs of a session one after another, and advances to the time of each. From the
  /// same state, the session of another simulation gives bitwise the same results.
  void play(const std::vector<Input>& session);
  /// All inputs of this simulation since it was made or restored.
  const std::vector<Input>& session() const;

  /// Writes the whole state, including loads that were set, but no input for a later time. Throws
  /// RunError.
  void save(const std::filesystem::path& file) const;
  /// Continues from a file that a simulation of the same case has saved, to the same bits. Throws
  /// InputError when it is that of another case, RunError when it cannot be read.
  void restore(const std::filesystem::path& file);

 private:
  int checked(int body) const;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
