#include "engine/simulation/run_identity.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include "engine/case/writing/resolved.hpp"

namespace pliant {
namespace {

/// FNV-1a with 64 bits: it detects a changed file, but does not resist an attacker.
std::string hash_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

std::string content_hash(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be read; check its path", file));
  return hash_of(std::string{std::istreambuf_iterator<char>(stream), {}});
}

void add_meshes(const Shape& shape, std::string& lines) {
  if (shape.kind == Shape::Kind::mesh)
    lines += fmt::format("{} {}\n", content_hash(shape.file), shape.file);
  for (const Shape& operand : shape.operands) add_meshes(operand, lines);
}

/// One line "hash path" for each mesh and each track of the case.
std::string file_hashes(const Case& settings) {
  std::string lines;
  for (const BodyCase& body : settings.bodies) add_meshes(body.geometry, lines);
  for (const BoundaryCase& boundary : settings.boundaries) add_meshes(boundary.geometry, lines);
  for (const CutCase& cut : settings.cuts) {
    if (cut.track.file.empty()) continue;
    lines += fmt::format("{} {}\n", content_hash(cut.track.file), cut.track.file);
  }
  return lines;
}

std::string with_end(Case settings, double end) {
  settings.time.end = end;
  return resolved_toml(settings);
}

/// The first line in which two cases differ, and the table that contains it.
std::string first_difference(const std::string& earlier, const std::string& present) {
  std::istringstream earlier_lines(earlier), present_lines(present);
  std::string table = "the case", was, is;
  while (true) {
    const bool had = static_cast<bool>(std::getline(earlier_lines, was));
    const bool has = static_cast<bool>(std::getline(present_lines, is));
    if (!had) was = "nothing";
    if (!has) is = "nothing";
    if (was != is || !had || !has)
      return fmt::format("{} had `{}`, and has `{}` now", table, was, is);
    if (is.starts_with('[')) table = is;
  }
}

/// The path of the first line "hash path" that differs.
std::string changed_file(const std::string& earlier, const std::string& present) {
  std::istringstream earlier_lines(earlier), present_lines(present);
  std::string was, is;
  while (std::getline(present_lines, is) && std::getline(earlier_lines, was) && was == is) {
  }
  return is.substr(is.find(' ') + 1);
}

}  // namespace

std::string identity_of(const Case& settings) {
  return hash_of(with_end(settings, 0) + file_hashes(settings));
}

void put_identity(ArchiveWriter& archive, const Case& settings) {
  archive.put("case", resolved_toml(settings));
  archive.put("end", settings.time.end);
  archive.put("mesh_hashes", file_hashes(settings));
}

void require_same_run(const ArchiveReader& archive, const Case& settings) {
  constexpr auto remedy = "run without --resume, which starts anew";
  const double end = archive.scalar<double>("end");
  const std::string earlier = archive.text("case"), present = with_end(settings, end);
  if (earlier != present) {
    throw InputError(fmt::format(
        "{}: this checkpoint belongs to a run with other settings: {}; give the settings "
        "of that run, as in {}, or {}",
        archive.path().string(), first_difference(earlier, present),
        (archive.path().parent_path() / "case.resolved.toml").string(), remedy));
  }
  if (settings.time.end < end) {
    throw InputError(
        fmt::format("{}: time.end = {} is earlier than {}, the end of the run to continue; "
                    "give that or a later one, or {}",
                    archive.path().string(), settings.time.end, end, remedy));
  }
  const std::string hashes = archive.text("mesh_hashes"), present_hashes = file_hashes(settings);
  if (hashes != present_hashes) {
    throw InputError(
        fmt::format("{}: this file has changed since the checkpoint {}; put back "
                    "the earlier file, or {}",
                    changed_file(hashes, present_hashes), archive.path().string(), remedy));
  }
}

}  // namespace pliant
