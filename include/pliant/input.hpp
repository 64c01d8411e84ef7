#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// An action of a caller on a simulation, with its time: a tool moves, a load changes, time passes.
/// A list of inputs is a session, which can be stored and played again.
struct Input {
  enum class Kind {
    advance,        ///< time passes up to `time`, on the way to `until`
    pressure,       ///< the boundary `name` gets the pressure `value` [Pa]
    wall_velocity,  ///< the boundary `name` gets the velocity `first` [m/s]
    blade,          ///< the edge of the cut `name` moves to `first` .. `second` [m]
    lift            ///< the blade of the cut `name` leaves the body
  };

  Kind kind = Kind::advance;
  double time = 0;   ///< simulated time at which it takes effect [s]
  std::string name;  ///< of a boundary or a cut of the case
  double until = 0;  ///< [s]
  double value = 0;
  std::array<double, 3> first = {}, second = {};
};

/// Reads a session: CSV with the header `time,input,name,x1,y1,z1,x2,y2,z2` and one row for each
/// input. `input` is one of the kinds; `x1` holds `until` or `value`. Unused fields at the end of a
/// row may be left out. Rows are in ascending order of time. Throws InputError with file and line.
std::vector<Input> read_inputs(const std::filesystem::path& file);

/// Writes a session that read_inputs reads back bitwise. Throws RunError.
void write_inputs(const std::filesystem::path& file, const std::vector<Input>& inputs);

}  // namespace pliant
