#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// The edge of a blade, in the undeformed body [m]; in 2D it is `from`.
struct BladeEdge {
  Vector from = {}, to = {};
};

/// The edge of a blade at `time` [s]; outside the times of its track, at the nearer end.
BladeEdge edge_of(const CutCase& cut, double time);

/// Intervals in which a path that may be curved or turn back is followed.
inline constexpr int path_intervals = 128;

/// The edge of a blade after a number of these intervals, which need not be whole.
BladeEdge edge_on_path(const CutCase& cut, double interval);

/// The edge of a blade at the ends of the intervals, from `start` to `end` of the cut.
std::vector<BladeEdge> edges_along_path(const CutCase& cut);

/// Whether a blade moves before the run ends. One that starts at the end or later waits for a
/// caller of the library to move it.
inline bool moves_in_run(const CutCase& cut, const Case& a_case) {
  return cut.start < a_case.time.end;
}

/// Reads the track of a cut from its file, and its first and last time: CSV, a header and one row
/// for each time. The header is `time,x,y` in 2D. In 3D it is `time,x1,y1,z1,x2,y2,z2`, with the
/// ends of the edge, or `time,x,y,z,qw,qx,qy,qz`, with its start and a quaternion that rotates the
/// edge of the case. Throws std::runtime_error with file, line and remedy.
void load_track(CutCase& cut, int dimension);

}  // namespace pliant
