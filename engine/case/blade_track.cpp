#include "engine/case/blade_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

namespace pliant {

namespace {

constexpr std::string_view header_2d = "time,x,y", header_ends = "time,x1,y1,z1,x2,y2,z2",
                           header_turns = "time,x,y,z,qw,qx,qy,qz";

using TrackRow = std::vector<double>;

TrackRow track_row(const std::string& text, std::size_t columns, const std::string& place) {
  TrackRow row;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double value = 0;
    const auto [last, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    if (error != std::errc() || last != text.data() + end || !std::isfinite(value)) {
      throw std::runtime_error(
          fmt::format("{}: column {} must be a finite number, got `{}`; give a number", place,
                      row.size() + 1, text.substr(begin, end - begin)));
    }
    row.push_back(value);
    begin = end + 1;
  }
  if (row.size() == columns) return row;
  throw std::runtime_error(
      fmt::format("{}: {} columns, where the header has {}; give a value for "
                  "each column",
                  place, row.size(), columns));
}

/// v rotated by the quaternion (w, q), of any non-zero length.
Vector turned(const Vector& v, double w, const Vector& q) {
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const double square = w * w + q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
  const Vector once = cross(q, v), twice = cross(q, once);
  Vector result = v;
  for (int a = 0; a < 3; ++a) result[a] += 2 * (w * once[a] + twice[a]) / square;
  return result;
}

void add_track_row(const TrackRow& row, bool turns, const std::string& place, CutCase& cut) {
  BladeTrack& track = cut.track;
  if (!track.time.empty() && row[0] <= track.time.back()) {
    throw std::runtime_error(fmt::format("{}: t = {} comes after t = {}; sort the rows by time",
                                         place, row[0], track.time.back()));
  }
  Vector from = {row[1], row[2], row.size() > 3 ? row[3] : 0}, to = from;
  if (turns) {
    if (row[4] == 0 && row[5] == 0 && row[6] == 0 && row[7] == 0) {
      throw std::runtime_error(fmt::format(
          "{}: a quaternion of zeros has no direction; 1,0,0,0 leaves the edge as it is", place));
    }
    Vector edge;
    for (int a = 0; a < 3; ++a) edge[a] = cut.edge.value_or(VectorExpression{})[a](0);
    edge = turned(edge, row[4], {row[5], row[6], row[7]});
    for (int a = 0; a < 3; ++a) to[a] += edge[a];
  } else if (row.size() > 4) {
    to = {row[4], row[5], row[6]};
  }
  track.time.push_back(row[0]);
  track.from.push_back(from);
  track.to.push_back(to);
}

}  // namespace

BladeEdge edge_of(const CutCase& cut, double time) {
  const BladeTrack& track = cut.track;
  BladeEdge edge{cut.from, cut.to};
  if (!track.time.empty()) {
    const auto after = std::upper_bound(track.time.begin(), track.time.end(), time);
    const auto next = std::clamp<std::ptrdiff_t>(
        after - track.time.begin(), 1, static_cast<std::ptrdiff_t>(track.time.size()) - 1);
    const double begin = track.time[next - 1], length = track.time[next] - begin;
    const double share = std::clamp((time - begin) / length, 0., 1.);
    for (int a = 0; a < 3; ++a) {
      edge.from[a] = (1 - share) * track.from[next - 1][a] + share * track.from[next][a];
      edge.to[a] = (1 - share) * track.to[next - 1][a] + share * track.to[next][a];
    }
    return edge;
  }
  for (int a = 0; a < 3; ++a) {
    const double moved = cut.path[a](time);
    edge.from[a] += moved;
    edge.to[a] = cut.edge ? edge.from[a] + (*cut.edge)[a](time) : edge.to[a] + moved;
  }
  return edge;
}

BladeEdge edge_on_path(const CutCase& cut, double interval) {
  return edge_of(cut, cut.start + (cut.end - cut.start) * interval / path_intervals);
}

std::vector<BladeEdge> edges_along_path(const CutCase& cut) {
  std::vector<BladeEdge> path;
  for (int k = 0; k <= path_intervals; ++k) path.push_back(edge_on_path(cut, k));
  return path;
}

void load_track(CutCase& cut, int dimension) {
  const std::string& file = cut.track.file;
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read; check the path", file));
  std::string text;
  std::size_t columns = 0;
  bool turns = false;
  for (int line = 1; std::getline(stream, text); ++line) {
    if (text.ends_with('\r')) text.pop_back();
    const std::string place = fmt::format("{}:{}", file, line);
    if (line > 1) {
      if (!text.empty()) add_track_row(track_row(text, columns, place), turns, place, cut);
      continue;
    }
    turns = dimension == 3 && text == header_turns;
    if (!turns && text != (dimension == 2 ? header_2d : header_ends)) {
      throw std::runtime_error(fmt::format(
          "{}: not the track of a blade in {}D; its first line must be `{}`", place, dimension,
          dimension == 2 ? std::string(header_2d)
                         : fmt::format("{}` or `{}", header_ends, header_turns)));
    }
    if (turns != cut.edge.has_value()) {
      throw std::runtime_error(fmt::format(
          "{}: {}", place,
          turns ? "quaternions turn the edge of the case, which has none; give the key edge"
                : "this track has both ends of the edge; take out the key edge"));
    }
    columns = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
  }
  if (cut.track.time.size() < 2) {
    throw std::runtime_error(fmt::format(
        "{}: a track needs two times or more, and has {}; add rows", file, cut.track.time.size()));
  }
  cut.start = cut.track.time.front();
  cut.end = cut.track.time.back();
}

}  // namespace pliant
