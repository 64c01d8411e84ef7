#include "engine/cli/new_case.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include "engine/output/atomic_file.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::cli {

namespace {

std::string with(std::string text, std::string_view place, const std::string& word) {
  for (std::size_t at = text.find(place); at != text.npos; at = text.find(place, at)) {
    text.replace(at, place.size(), word);
  }
  return text;
}

/// The default output folder of `pliant run`: a case is named after its folder.
std::string results_of(const std::filesystem::path& folder) {
  const auto normal = (folder / "").lexically_normal();
  return "results/" + normal.parent_path().filename().string();
}

void add_mesh_files(const Shape& shape, std::vector<std::filesystem::path>& files) {
  for (const Shape& part : shape.operands) add_mesh_files(part, files);
  if (shape.kind == Shape::Kind::mesh) files.emplace_back(shape.file);
}

/// Mesh files of a case, relative to its folder. Files outside the folder are not listed: either
/// their paths are absolute, or InputError is thrown.
std::vector<std::filesystem::path> mesh_files(const Case& settings,
                                              const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files, inside;
  for (const BodyCase& body : settings.bodies) add_mesh_files(body.geometry, files);
  for (const BoundaryCase& boundary : settings.boundaries) {
    add_mesh_files(boundary.geometry, files);
  }
  for (const std::filesystem::path& file : files) {
    const auto relative = std::filesystem::absolute(file).lexically_normal().lexically_relative(
        std::filesystem::absolute(folder).lexically_normal());
    if (!relative.empty() && *relative.begin() != "..")
      inside.push_back(relative);
    else
      throw InputError(
          fmt::format("{}: is outside the folder of the case; copy it there first", file.string()));
  }
  return inside;
}

/// Copies a valid case with the files that it names.
void copy_case(const std::filesystem::path& from, const std::filesystem::path& folder,
               const std::string& name) {
  const std::filesystem::path file = case_path(from);
  const std::filesystem::path source = file.has_parent_path() ? file.parent_path() : ".";
  const auto meshes = mesh_files(read_case(file), source);
  std::filesystem::create_directories(folder);
  for (const std::filesystem::path& mesh : meshes) {
    std::filesystem::create_directories((folder / mesh).parent_path());
    std::filesystem::copy_file(source / mesh, folder / mesh);
  }
  const std::string heading = fmt::format(
      "# Copied from {0}.\n#\n#   pliant check {1}   says what it would run\n"
      "#   pliant run {1}     writes {2}\n\n",
      file.string(), name, results_of(folder));
  write_atomically(folder / "case.toml", heading + case_text(file), Durable::no);
}

}  // namespace

ExitStatus new_case(const NewArguments& arguments) {
  const std::filesystem::path& folder = arguments.folder;
  const std::filesystem::path file = folder / "case.toml";
  if (std::filesystem::exists(file)) {
    throw InputError(
        fmt::format("{}: exists already; give another name, or remove it", file.string()));
  }
  const std::string name = folder.lexically_normal().string();
  if (arguments.from) {
    copy_case(*arguments.from, folder, name);
  } else {
    std::filesystem::create_directories(folder);
    const std::string text = with(std::string(new_case_text), "@NAME@", name);
    write_atomically(file, with(text, "@RESULTS@", results_of(folder)), Durable::no);
  }
  fmt::print("{}: edit it, then run it with `pliant run {}`\n", file.string(), name);
  return ExitStatus::done;
}

}  // namespace pliant::cli
