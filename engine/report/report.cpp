#include "engine/report/report.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "engine/boundaries/rigid_motion.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/output/error.hpp"
#include "engine/report/packed_frames.hpp"
#include "engine/report/page.hpp"
#include "engine/report/references.hpp"
#include "engine/report/run_reader.hpp"
#include "engine/report/walls.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_rows = 3000;  ///< in a history

/// Number of rows of a history for each row that the page draws.
std::size_t stride_of(std::size_t rows) { return (rows + most_rows - 1) / most_rows; }

Json json_of(const History& history, std::size_t stride) {
  Json time = Json::array(), value = Json::array();
  const auto rows = history.time.size();
  for (std::size_t i = 0; i < rows; i += stride) {
    const auto row = i + stride >= rows ? rows - 1 : i;  // always includes the last row
    time.push_back(history.time[row]);
    value.push_back(history.value[row]);
  }
  return {{"name", history.name}, {"unit", history.unit}, {"time", time}, {"value", value}};
}

Json json_of(const PackedFrames& packed) {
  Json sets = Json::array(), fields = Json::array();
  for (const auto& set : packed.sets)
    sets.push_back({{"kind", set.kind},
                    {"corners", set.corners},
                    {"points", set.points},
                    {"pieces", set.pieces},
                    {"same", set.same}});
  for (std::size_t s = 0; s < packed.scalars.size(); ++s) {
    const auto& scalar = packed.scalars[s];
    fields.push_back({{"name", scalar.name},
                      {"label", scalar.label},
                      {"unit", scalar.unit},
                      {"lo", packed.range[s][0]},
                      {"hi", packed.range[s][1]}});
  }
  const double size = std::max({packed.sides[0], packed.sides[1], packed.sides[2], 1e-300});
  Json sides = Json::array();
  for (const double side : packed.sides) sides.push_back(side / size);
  return {
      {"times", packed.times},
      {"shift", packed.thinning.shift},
      {"box", {{"origin", packed.origin}, {"size", size}, {"low", {0, 0, 0}}, {"sides", sides}}},
      {"fields", fields},
      {"sets", sets}};
}

/// The box of the bodies over the run, with a margin in which walls are shown.
Box<3> box_around(const PackedFrames& packed, int dimension) {
  constexpr double margin = 0.12;
  const double size = std::max({packed.sides[0], packed.sides[1], packed.sides[2]});
  Box<3> box;
  for (int a = 0; a < 3; ++a) {
    const double more = a < dimension ? margin * size : 0;
    box.lower[a] = packed.origin[a] - more;
    box.upper[a] = packed.origin[a] + packed.sides[a] + more;
  }
  return box;
}

/// The displacement of the page's origin with a wall in a frame: the page rotates a wall about the
/// origin.
Vector shift_in(const WallPicture& wall, std::size_t frame, const Vector& origin) {
  Vector shift = wall.shift[frame];
  if (wall.angle.empty()) return shift;
  Vector from_centre;
  for (int a = 0; a < 3; ++a) from_centre[a] = origin[a] - wall.centre[a];
  const Vector turned = Turn(wall.axis, wall.angle[frame])(from_centre);
  for (int a = 0; a < 3; ++a) shift[a] += turned[a] - from_centre[a];
  return shift;
}

/// Walls in units of the page, in which the longest side of the bodies' box is 1.
Json walls_of(const std::string& settings, const PackedFrames& packed, int dimension, Json& notes) {
  Json walls = Json::array();
  const double size = std::max({packed.sides[0], packed.sides[1], packed.sides[2], 1e-300});
  const auto rounded = [](double x) { return std::round(1e5 * x) / 1e5; };
  const auto place = [&](const Vector& x) {
    Json json = Json::array();
    for (int a = 0; a < 3; ++a) json.push_back(rounded((x[a] - packed.origin[a]) / size));
    return json;
  };
  try {
    const Case a_case = parse_case(settings, "case.toml", {}, methods().rules());
    for (const WallPicture& wall :
         picture_walls(a_case, box_around(packed, dimension), packed.times)) {
      Json position = Json::array(), shift = Json::array();
      for (const Vector& x : wall.vertex) {
        for (const Json& one : place(x)) position.push_back(one);
      }
      for (std::size_t frame = 0; frame < wall.shift.size(); ++frame) {
        const Vector x = shift_in(wall, frame, packed.origin);
        shift.push_back({rounded(x[0] / size), rounded(x[1] / size), rounded(x[2] / size)});
      }
      Json one = {{"name", wall.name},
                  {"is_plane", wall.is_plane},
                  {"position", position},
                  {"triangles", wall.triangle}};
      if (!shift.empty()) one["shift"] = shift;
      if (!wall.angle.empty()) {
        one["axis"] = wall.axis;
        one["angle"] = wall.angle;
      }
      walls.push_back(one);
    }
  } catch (const InputError&) {  // for example if a mesh file is missing
    notes.push_back("The walls of the case cannot be read, and are not shown.");
  }
  return walls;
}

/// The notes of the page about itself.
Json notes_of(const RunReader& run, const PackedFrames& packed, std::size_t scalars,
              bool has_summary, std::size_t stride) {
  Json notes = Json::array();
  const auto& [shift, kept, every_frame, every_particle] = packed.thinning;
  if (!has_summary)
    notes.push_back(
        "The run has not reached its end: it is still running, or was interrupted. The same "
        "`pliant run` with --resume continues it.");
  if (run.frames().empty()) notes.push_back("It has no complete frame yet.");
  if (every_frame > 1)
    notes.push_back(
        fmt::format("This page shows {} of {} frames.", packed.times.size(), run.frames().size()));
  if (every_particle > 1)
    notes.push_back(fmt::format("It shows one in {} particles.", every_particle));
  if (kept < scalars)
    notes.push_back(
        fmt::format("It shows {} of {} fields; --field NAME chooses others.", kept, scalars));
  if (shift > 0)
    notes.push_back(fmt::format("Positions and fields are shown with {} bits.", 16 - shift));
  if (stride > 1) notes.push_back(fmt::format("Curves show one in {} samples.", stride));
  if (run.dimension() == 3 && run.corners() == 0 && !run.frames().empty())
    notes.push_back("Run with --set output.surface=true to see surfaces instead of particles.");
  return notes;
}

/// The summary of the run; null if there is none.
Json read_summary(const std::filesystem::path& folder) {
  const auto path = folder / "summary.json";
  std::ifstream file(path, std::ios::binary);
  if (!file) return nullptr;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Json summary = Json::parse(text, nullptr, false);
  if (summary.is_discarded() || !summary.is_object())
    throw OutputError(path, "is no JSON", "run the case again, or remove the file");
  return summary;
}

/// Particle spacing, and the axis against gravity; z without gravity.
struct Layout {
  double spacing = 0;
  std::string up = "z";
  bool has_boundaries = false;
};

Layout layout_of(const std::string& settings) {
  Layout layout;
  try {
    const toml::table table = toml::parse(settings);
    layout.spacing = table.at_path("discretisation.spacing").value_or(0.0);
    layout.has_boundaries = table.contains("boundary");
    const toml::node_view gravity = table["gravity"];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (gravity[axis].value_or(0.0) < 0) layout.up = std::string(1, "xyz"[axis]);
    }
  } catch (const toml::parse_error&) {
    // A picture with coarser particles is better than none.
  }
  return layout;
}

std::vector<History> references_of(const ReportOptions& options, const std::string& name) {
  if (options.reference) return read_references(*options.reference);
  const auto usual = std::filesystem::path("cases") / name / "reference.csv";
  std::error_code error;
  return std::filesystem::exists(usual, error) ? read_references(usual) : std::vector<History>{};
}

Json histories_of(const RunReader& run, const std::vector<History>& references,
                  std::size_t& stride) {
  Json histories = Json::array();
  for (const auto& history : run.histories()) {
    const auto own = stride_of(history.time.size());
    stride = std::max(stride, own);
    Json one = json_of(history, std::max<std::size_t>(own, 1));
    Json curves = Json::array();
    for (const auto& reference : references) {
      if (is_reference_of(history.name, reference.name))
        curves.push_back(
            json_of(reference, std::max<std::size_t>(stride_of(reference.time.size()), 1)));
    }
    one["references"] = curves;
    histories.push_back(one);
  }
  return histories;
}

std::vector<Scalar> scalars_of(const RunReader& run, const std::vector<std::string>& names) {
  std::vector<Scalar> scalars;
  if (names.empty()) scalars = default_scalars(run.fields());
  scalars.reserve(names.size());
  for (const auto& name : names) scalars.push_back(scalar_named(name, run.fields()));
  for (auto& scalar : scalars) scalar.unit = run.unit_of(scalar.field);
  return scalars;
}

}  // namespace

void write_run_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                      const ReportOptions& options) {
  const RunReader run(folder);
  const std::string name = run.text("case"), title = run.text("title"), settings = run.settings();
  const Json summary = read_summary(folder);
  const auto scalars = scalars_of(run, options.fields);
  std::size_t stride = 1;
  const Json histories = histories_of(run, references_of(options, name), stride);
  const std::string rest = histories.dump() + summary.dump() + settings;
  const std::size_t taken = empty_page().size() + 2 * rest.size() + 100'000;
  const auto packed = pack(run, scalars, options.limit > taken ? options.limit - taken : 0);
  const Layout layout = layout_of(settings);
  const double kept = 1 / static_cast<double>(packed.thinning.every_particle);
  Json json = {{"kind", "run"},
               {"case", name},
               {"title", title},
               {"method", run.text("method")},
               {"dimension", run.dimension()},
               {"up", layout.up},
               {"spacing", layout.spacing * std::pow(kept, -1.0 / run.dimension())}};
  Json notes = notes_of(run, packed, scalars.size(), !summary.is_null(), stride);
  json["walls"] =
      layout.has_boundaries ? walls_of(settings, packed, run.dimension(), notes) : Json::array();
  json["notes"] = notes;
  json.update(json_of(packed));
  json["histories"] = histories;
  json["summary"] = summary;
  json["settings"] = settings;
  const auto text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  write_atomically(page, page_of(title.empty() ? name : title, text, packed.frames), Durable::no);
}

}  // namespace pliant::report
