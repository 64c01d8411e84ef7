#include "engine/case/reading/read_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "engine/case/blade_track.hpp"
#include "engine/case/checks/check.hpp"
#include "engine/case/checks/stability.hpp"
#include "engine/case/elastic_constants.hpp"
#include "engine/case/placement.hpp"
#include "engine/case/reading/settings.hpp"
#include "engine/case/reading/table_reader.hpp"
#include "engine/case/vocabulary/vocabulary.hpp"
#include "engine/geometry/mesh_files/load_meshes.hpp"
#include "engine/geometry/surface_mesh.hpp"

namespace pliant {
namespace {

toml::table parse(const std::string& text, const std::filesystem::path& file) {
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    if (error.description().find("utf-8") != std::string_view::npos) {
      throw CaseError(fmt::format("{}:{}: not UTF-8 text; save the file as UTF-8", file.string(),
                                  error.source().begin.line));
    }
    throw CaseError(fmt::format(
        "{}:{}: not TOML: {}; correct the line: write texts in quotes, lists in brackets, "
        "and every key once",
        file.string(), error.source().begin.line, error.description()));
  }
}

/// Names of the tables in the list `key`, empty where one has none.
std::vector<std::string> names_in(const toml::table& root, std::string_view key) {
  std::vector<std::string> names;
  const toml::array* tables = root[key].as_array();
  if (!tables) return names;
  for (const toml::node& element : *tables) {
    const toml::table* table = element.as_table();
    names.push_back(table ? (*table)["name"].value_or(std::string()) : std::string());
  }
  return names;
}

bool has_all_files(const Shape& shape) {
  return std::all_of(shape.operands.begin(), shape.operands.end(), has_all_files) &&
         (shape.kind != Shape::Kind::mesh || !shape.file.empty());
}

/// Loads the meshes of the shapes in [[list]].
template <class Element>
void load_meshes_of(std::vector<Element>& elements, std::string_view list, const Check& check) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!has_all_files(elements[i].geometry)) continue;  // already reported
    try {
      load_meshes(elements[i].geometry);
    } catch (const MeshError& error) {
      check.problems.add(check.place(list, i, "geometry"),
                         fmt::format("geometry has a faulty mesh: {}", error.what()),
                         error.remedy());
    }
  }
}

void load_tracks(Case& a_case, const Check& check) {
  for (std::size_t i = 0; i < a_case.cuts.size(); ++i) {
    if (a_case.cuts[i].track.file.empty()) continue;
    try {
      load_track(a_case.cuts[i], a_case.dimension);
    } catch (const std::runtime_error& error) {
      const std::string fault = error.what();
      const std::size_t remedy = fault.rfind("; ");
      check.problems.add(check.place("cut", i, "track"),
                         fmt::format("cut \"{}\" has a faulty track: {}", a_case.cuts[i].name,
                                     fault.substr(0, remedy)),
                         fault.substr(remedy + 2));
    }
  }
}

/// The damping rate of [discretisation], where the table of the method has none of its own.
void share_damping(const toml::table& root, Case& a_case) {
  if (a_case.rules == nullptr || a_case.rules->damping == nullptr) return;
  if (root[a_case.method]["damping"]) return;
  a_case.rules->damping(a_case.parameters) = a_case.discretisation.damping;
}

/// Ties hold best as long as the particles beside them keep their places to each other,
/// docs/decisions/0072.
void spare_ties_remeshings(const toml::table& root, Case& a_case) {
  if (!has_supported_ties(a_case) || !is_remeshed(a_case)) return;
  const auto remeshing = root["remeshing"];
  if (!remeshing["strain_threshold"]) a_case.remeshing.strain_threshold = 0.4;
  if (!remeshing["deformation_threshold"]) a_case.remeshing.deformation_threshold = 1;
}

std::string default_name(const std::filesystem::path& file) {
  if (file.filename() == "case.toml") {
    // "." and ".." are not names of folders.
    const auto folder = std::filesystem::absolute(file).lexically_normal().parent_path();
    return folder.has_filename() ? folder.filename().string() : "case";
  }
  return file.stem().string();
}

}  // namespace

std::filesystem::path case_path(const std::filesystem::path& path) {
  std::error_code unreadable;  // reported when the file is opened
  return std::filesystem::is_directory(path, unreadable) ? path / "case.toml" : path;
}

std::string case_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw CaseError(
        fmt::format("{}: cannot be read; give the path of a case file, or of a folder "
                    "with a case.toml",
                    file.string()));
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Case read_case(const std::filesystem::path& path, std::span<const std::string> settings,
               MethodList methods) {
  const std::filesystem::path file = case_path(path);
  return parse_case(case_text(file), file, settings, methods);
}

Case parse_case(const std::string& text, const std::filesystem::path& file,
                std::span<const std::string> settings, MethodList methods) {
  toml::table root = parse(text, file);
  Problems problems;
  apply_settings(root, settings, problems);

  Reading reading{problems,
                  root,
                  std::filesystem::absolute(file).parent_path(),
                  2,
                  names_in(root, "body"),
                  names_in(root, "boundary"),
                  names_in(root, "cut"),
                  names_in(root, "measurement"),
                  methods};
  if (root["dimension"].value<int>() == 3) reading.dimension = 3;
  Case a_case;
  a_case.name = default_name(file);
  TableReader reader(root, "the case", Place{file.string(), 1}, reading);
  case_keys(reader, a_case);
  reader.finish();
  share_damping(root, a_case);
  spare_ties_remeshings(root, a_case);
  const Place start{file.string(), 1};
  const Check check{a_case, root, start, methods, problems};
  load_meshes_of(a_case.bodies, "body", check);
  load_meshes_of(a_case.boundaries, "boundary", check);
  load_tracks(a_case, check);
  check_case(check);
  if (!problems.empty()) throw CaseError(problems.text());

  for (BodyCase& body : a_case.bodies) {
    body.material = elastic_constants(body.material_as_given);
    body.prony = prony_terms(body.material_as_given.prony);
    body.prony_shear = prony_terms(body.material_as_given.prony_shear);
  }
  // It must not depend on the end of the run: a run that is continued to a later end moves its
  // walls like one long run.
  const double of_a_wave = a_case.discretisation.spacing / fastest_wave(a_case);
  for (BoundaryCase& boundary : a_case.boundaries) boundary.time_increment = of_a_wave / 100;
  return a_case;
}

}  // namespace pliant
