#include "tests/engine/output/sample_frames.hpp"

#include <algorithm>
#include <numeric>

namespace pliant::test {
namespace {

double value(int frame, int particle, int component) {
  return frame + 1e-3 * component + 1e-7 * particle;
}

template <class T>
std::vector<T> rows(const FileContent& content, const std::string& path, std::int64_t first,
                    std::int64_t count, int components = 1) {
  const auto all = content.at(path).as<T>();
  const auto begin = first * components, end = (first + count) * components;
  if (static_cast<std::int64_t>(all.size()) < end) throw std::runtime_error(path + " is too short");
  return {all.begin() + begin, all.begin() + end};
}

template <class T>
void require_equal(const std::vector<T>& found, const std::vector<T>& expected,
                   const std::string& path) {
  if (found != expected) throw std::runtime_error(path + " holds other values");
}

/// Finds a frame as a VTKHDF reader does: only by its entries in Steps.
void require_frame(const FileContent& content, int f, const Frame& frame) {
  const std::string root = "/VTKHDF/", steps = "/VTKHDF/Steps/";
  const auto entry = [&](const std::string& path) {
    return rows<std::int64_t>(content, path, f, 1).front();
  };
  const auto particles = static_cast<std::int64_t>(frame.position.size() / 3);
  require_equal(rows<double>(content, steps + "Values", f, 1), {frame.time}, "Values");
  require_equal(rows<std::int64_t>(content, "/frames/step", f, 1), {frame.step}, "step");
  const auto part = entry(steps + "PartOffsets"), first = entry(steps + "PointOffsets");
  require_equal(rows<std::int64_t>(content, root + "NumberOfPoints", part, 1), {particles},
                "NumberOfPoints");
  require_equal(rows<std::int64_t>(content, root + "Vertices/NumberOfCells", part, 1), {particles},
                "NumberOfCells");
  require_equal(rows<double>(content, root + "Points", first, particles, 3), frame.position,
                "Points");

  // Offsets of the frame follow those of all earlier parts, one more than their cells each.
  const auto cells = rows<std::int64_t>(content, steps + "CellOffsets", f, 1, 4);
  const auto connections = rows<std::int64_t>(content, steps + "ConnectivityIdOffsets", f, 1, 4);
  std::vector<std::int64_t> count(static_cast<std::size_t>(particles) + 1);
  std::iota(count.begin(), count.end(), 0);
  require_equal(
      rows<std::int64_t>(content, root + "Vertices/Offsets", cells[0] + part, particles + 1), count,
      "Offsets");
  count.pop_back();
  require_equal(
      rows<std::int64_t>(content, root + "Vertices/Connectivity", connections[0], particles), count,
      "Connectivity");
  for (const std::string topology : {"Lines", "Polygons", "Strips"}) {
    require_equal(rows<std::int64_t>(content, root + topology + "/NumberOfCells", part, 1), {0},
                  topology);
    require_equal(rows<std::int64_t>(content, root + topology + "/Offsets", part, 1), {0},
                  topology);
  }

  for (const auto& field : frame.fields) {
    const auto path = root + "PointData/" + field.name;
    const auto offset = entry(steps + "PointDataOffsets/" + field.name);
    std::visit(
        [&]<class T>(std::vector<T> values) {
          if (field.components == 2) {
            std::vector<T> three;
            for (std::size_t i = 0; i < values.size(); i += 2)
              three.insert(three.end(), {values[i], values[i + 1], T(0)});
            values = three;
          }
          const auto components = field.components == 2 ? 3 : field.components;
          require_equal(rows<T>(content, path, offset, particles, components), values, path);
        },
        field.values);
  }
}

/// The number of pieces varies from frame to frame; one frame in five has none.
FrameSurface sample_surface(int number) {
  const int vertices = number % 5 == 3 ? 0 : 40 + number * 17 % 60;
  FrameSurface surface;
  std::vector<double> velocity;
  for (int v = 0; v < vertices; ++v) {
    for (int c = 0; c < 3; ++c) surface.position.push_back(value(number, v, 40 + c));
    for (int c = 0; c < 2; ++c) velocity.push_back(value(number, v, 50 + c));
    if (v >= 2) surface.vertex.insert(surface.vertex.end(), {v, v - 1, v - 2});
  }
  surface.fields = {{"velocity", "m/s", 2, velocity}};
  return surface;
}

/// The surface of frame `f`, after those of all earlier frames.
void require_surface(const FileContent& content, int f) {
  std::int64_t first_vertex = 0, first_piece = 0;
  for (int before = 0; before < f; ++before) {
    const FrameSurface surface = sample_surface(before);
    first_vertex += static_cast<std::int64_t>(surface.position.size() / 3);
    first_piece += static_cast<std::int64_t>(surface.vertex.size() / 3);
  }
  const FrameSurface surface = sample_surface(f);
  const auto vertices = static_cast<std::int64_t>(surface.position.size() / 3);
  const auto pieces = static_cast<std::int64_t>(surface.vertex.size() / 3);
  require_equal(rows<std::int64_t>(content, "/surface/NumberOfPoints", f, 1), {vertices},
                "surface NumberOfPoints");
  require_equal(rows<std::int64_t>(content, "/surface/NumberOfCells", f, 1), {pieces},
                "surface NumberOfCells");
  require_equal(rows<double>(content, "/surface/Points", first_vertex, vertices, 3),
                surface.position, "surface Points");
  require_equal(rows<std::int64_t>(content, "/surface/Connectivity", first_piece, pieces, 3),
                surface.vertex, "surface Connectivity");
  const auto found =
      rows<double>(content, "/surface/PointData/velocity", first_vertex, vertices, 3);
  for (std::int64_t v = 0; v < vertices; ++v) {
    const double* u = found.data() + 3 * v;
    const auto p = static_cast<int>(v);
    require_equal<double>({u[0], u[1], u[2]}, {value(f, p, 50), value(f, p, 51), 0.0},
                          "surface velocity");
  }
}

}  // namespace

Frame sample_frame(int number, int least) {
  const int particles = least + number * 37 % (least / 2 + 1);
  Frame frame;
  frame.time = 0.1 * number;
  frame.step = 10 * number;
  std::vector<double> velocity, stress, density;
  std::vector<std::int32_t> body;
  std::vector<std::int64_t> name;
  for (int p = 0; p < particles; ++p) {
    for (int c = 0; c < 3; ++c) frame.position.push_back(value(number, p, c));
    for (int c = 0; c < 2; ++c) velocity.push_back(value(number, p, 10 + c));
    for (int c = 0; c < 6; ++c) stress.push_back(value(number, p, 20 + c));
    density.push_back(value(number, p, 30));
    body.push_back(p % 3);
    name.push_back(std::int64_t{number} << 40 | p);
  }
  frame.fields = {{"velocity", "m/s", 2, velocity},
                  {"stress", "Pa", 6, stress},
                  {"density", "kg/m^3", 1, density},
                  {"body", "1", 1, body},
                  {"name", "1", 1, name}};
  frame.surface = sample_surface(number);
  return frame;
}

RunDescription sample_run() {
  return {.case_name = "sample",
          .title = "A made-up run",
          .method = "remeshed",
          .version = "0.1.0",
          .dimension = 2,
          .resolved_case = "[time]\nend = 1\n",
          .identity = "0123456789abcdef"};
}

void write_frames(ResultFile& file, int begin, int end, int least) {
  for (int f = begin; f < end; ++f) {
    for (int i = 0; i < 3; ++i) file.append_history("extent", "m", f + 0.1 * i, 100 * f + i);
    file.append(sample_frame(f, least));
  }
}

int whole_frames(const FileContent& content, int least) {
  const auto frames = content.at("/VTKHDF/Steps@NSteps").as<std::int32_t>().at(0);
  for (int f = 0; f < frames; ++f) {
    require_frame(content, f, sample_frame(f, least));
    require_surface(content, f);
  }
  return frames;
}

}  // namespace pliant::test
