#include <fmt/format.h>

#include <numeric>

#include "engine/case/reading/table_reader.hpp"
#include "engine/case/vocabulary/vocabulary.hpp"

/// Reading of values that are tables themselves: geometry, material, prony, rotation.
namespace pliant {
namespace {

/// Reads the keys of the table at `entry`; false if it is not a table or contains an error.
template <class Keys>
bool read_keys(const Entry& entry, std::string_view title, Keys&& keys) {
  const toml::table* table = entry.node.as_table();
  if (!table) return entry.refuse("must be a table, found " + describe(entry.node));
  const std::size_t problems = entry.reading.problems.count();
  TableReader reader(*table, std::string(title), place_of(*table), entry.reading);
  keys(reader);
  reader.finish();
  return entry.reading.problems.count() == problems;
}

bool read_material(const Entry& entry, std::string_view title, MaterialCase& material) {
  return read_keys(entry, title, [&](auto& keys) { material_keys(keys, material); });
}

bool check_corners(const Entry& entry, const Shape& box) {
  for (int i = 0; i < entry.reading.dimension; ++i) {
    if (box.lower[i] < box.upper[i]) continue;
    return entry.refuse(fmt::format("is a box with lower {} and upper {} along {}", box.lower[i],
                                    box.upper[i], words<Axis>[i].text),
                        "every component of lower must be less than that of upper");
  }
  return true;
}

}  // namespace

bool read(const Entry& entry, ShapeWord& value) {
  const int number = read_word(entry, words<ShapeWord>);
  if (number < 0) return false;
  value = static_cast<ShapeWord>(number);
  const bool flat = entry.reading.dimension == 2;
  if (flat && value == ShapeWord::mesh) {
    return entry.refuse("is a mesh, which needs dimension = 3",
                        "set dimension = 3, or use other shapes");
  }
  if (flat && (value == ShapeWord::ball || value == ShapeWord::cylinder)) {
    return entry.refuse(
        fmt::format("is a {}, which needs dimension = 3", words<ShapeWord>[number].text),
        "use shape = \"disc\" in 2D");
  }
  if (!flat && value == ShapeWord::disc) {
    return entry.refuse("is a disc, which needs dimension = 2",
                        R"(use shape = "ball" or "cylinder" in 3D)");
  }
  return true;
}

bool read(const Entry& entry, Shape& value) {
  const bool good = read_keys(entry, entry.key, [&](auto& keys) { shape_keys(keys, value); });
  if (!good) return false;
  // Resolved cases contain the full path, since they are in another folder than the case.
  if (value.kind == Shape::Kind::mesh) {
    value.file = (entry.reading.folder / value.file).lexically_normal().string();
  }
  return value.kind != Shape::Kind::box || check_corners(entry, value);
}

bool read(const Entry& entry, std::vector<Shape>& value) {
  const toml::array* list = entry.node.as_array();
  if (!list) return entry.refuse("must be a list of shapes, found " + describe(entry.node));
  if (list->size() < 2) {
    return entry.refuse(fmt::format("needs two parts or more, got {}", list->size()));
  }
  value.resize(list->size());
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Entry part{entry.key, *list->get(i), entry.notes, entry.reading};
    good = read(part, value[i]) && good;
  }
  return good;
}

bool read(const Entry& entry, MaterialCase& value) {
  const auto name = entry.node.value<std::string>();
  if (!name) return read_material(entry, entry.key, value);
  const toml::table* materials = entry.reading.root["material"].as_table();
  const toml::node* named = materials ? materials->get(*name) : nullptr;
  if (named) {
    return read_material({entry.key, *named, entry.notes, entry.reading},
                         fmt::format("[material.{}]", *name), value);
  }
  std::vector<std::string_view> known;
  if (materials) {
    for (const auto& [key, node] : *materials) known.push_back(key.str());
  }
  const std::string_view nearest = nearest_word(*name, known);
  return entry.refuse(fmt::format("names the material \"{}\", which does not exist", *name),
                      nearest.empty() ? fmt::format("add a table [material.{}]", *name)
                                      : fmt::format("did you mean \"{}\"?", nearest));
}

bool read(const Entry& entry, PronyCase& value) {
  if (!read_keys(entry, entry.key, [&](auto& keys) { prony_keys(keys, value); })) return false;
  if (value.ratios.size() != value.times.size()) {
    return entry.refuse(
        fmt::format("has {} ratios and {} times", value.ratios.size(), value.times.size()),
        "give one ratio and one time for each term");
  }
  const double sum = std::accumulate(value.ratios.begin(), value.ratios.end(), 0.0);
  if (sum < 1) return true;
  return entry.refuse(fmt::format("has ratios whose sum is {}, so that no modulus remains "
                                  "after relaxation",
                                  sum),
                      "their sum must be below 1");
}

bool read(const Entry& entry, Dissipation value) {
  if (!entry.node.is_table()) {
    if (!read(entry, value.strengths.velocity)) return false;
    value.strengths.stress = value.strengths.velocity;
    return true;
  }
  return read_keys(entry, entry.key, [&](auto& keys) { dissipation_keys(keys, value.strengths); });
}

bool read(const Entry& entry, std::optional<RigidRotation>& value) {
  return read_keys(entry, entry.key, [&](auto& keys) { rotation_keys(keys, value.emplace()); });
}

bool read(const Entry& entry, std::optional<WallRotation>& value) {
  return read_keys(entry, entry.key,
                   [&](auto& keys) { wall_rotation_keys(keys, value.emplace()); });
}

bool read(const Entry& entry, std::optional<StressExpression>& value) {
  return read_keys(entry, entry.key, [&](auto& keys) { stress_keys(keys, value.emplace()); });
}

void TableReader::materials(std::string_view key, std::string_view) {
  const toml::node* materials = find_table(key);
  if (!materials || !materials->is_table()) return;
  for (const auto& [name, node] : *materials->as_table()) {
    const std::string title = fmt::format("[{}.{}]", key, name.str());
    MaterialCase material;
    const Notes notes{.meaning = "", .example = "{ model = \"linear\", ... }"};
    read_material({name.str(), node, notes, reading_}, title, material);
  }
}

}  // namespace pliant
