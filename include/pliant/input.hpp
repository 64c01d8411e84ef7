#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// What a caller does to a simulation, and when: a tool that moves, a load that changes, time that
/// passes. A list of them is a session that can be written, read, and played again.
struct Input {
  enum class Kind {
    advance,        ///< time passes up to `time`, on the way to `until`
    pressure,       ///< of the boundary `name`: `value` [Pa]
    wall_velocity,  ///< of the boundary `name`: `first` [m/s]
    blade,          ///< the edge of the cut `name` moves to `first` .. `second` [m]
    lift            ///< the blade of the cut `name` leaves the body
  };

  Kind kind = Kind::advance;
  double time = 0;   ///< simulated time at which it enters [s]
  std::string name;  ///< of a boundary or a cut of the case
  double until = 0;  ///< [s]
  double value = 0;
  std::array<double, 3> first = {}, second = {};
};

/// Reads a session: CSV with the header `time,input,name,x1,y1,z1,x2,y2,z2`, a row for each input.
/// `input` is one of the kinds; `x1` holds `until` and `value`; unused fields at the end of a row
/// may be left out. Rows ascend in time. Throws InputError with file and line.
std::vector<Input> read_inputs(const std::filesystem::path& file);

/// Writes what read_inputs reads, to the same bits. Throws RunError.
void write_inputs(const std::filesystem::path& file, const std::vector<Input>& inputs);

}  // namespace pliant
