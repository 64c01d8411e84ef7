#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/case/reading/table_reader.hpp"
#include "engine/case/vocabulary/measurable_fields.hpp"

/// Reading of texts, words, flags and names.
namespace pliant {
namespace {

bool is_name(std::string_view text) {
  constexpr std::string_view letters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !text.empty() && text.find_first_not_of(letters) == text.npos;
}

bool read_reference(const Entry& entry, const std::vector<std::string>& names,
                    std::string_view what, int& index) {
  const auto text = entry.node.value<std::string>();
  if (!text) return entry.refuse("must be a text, found " + describe(entry.node));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != *text) continue;
    index = static_cast<int>(i);
    return true;
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return entry.refuse(fmt::format("names the {} \"{}\", which does not exist", what, *text),
                      known.empty() ? fmt::format("add a [[{}]] of that name", what)
                                    : suggestion(*text, known, "there are"));
}

}  // namespace

int read_word(const Entry& entry, std::span<const Word> known, std::string_view or_else) {
  std::vector<std::string_view> texts;
  for (const Word& word : known) texts.push_back(word.text);
  const std::string list = fmt::format("\"{}\"{}", fmt::join(texts, "\", \""), or_else);
  const auto text = entry.node.value<std::string>();
  if (!text) {
    entry.refuse(fmt::format("must be one of {}, found {}", list, describe(entry.node)));
    return -1;
  }
  for (const Word& word : known) {
    if (word.text == *text) return word.value;
  }
  const std::string_view nearest = nearest_word(*text, texts);
  entry.refuse(fmt::format("must be one of {}, got \"{}\"", list, *text),
               nearest.empty() ? "use one of these" : fmt::format("did you mean \"{}\"?", nearest));
  return -1;
}

bool read(const Entry& entry, bool& value) {
  const auto flag = entry.node.value_exact<bool>();
  if (!flag) return entry.refuse("must be true or false, found " + describe(entry.node));
  value = *flag;
  return true;
}

bool read(const Entry& entry, std::string& value) {
  const auto text = entry.node.value_exact<std::string>();
  if (!text) return entry.refuse("must be a text, found " + describe(entry.node));
  value = *text;
  return true;
}

bool read(const Entry& entry, Name value) {
  if (!read(entry, value.text)) return false;
  if (is_name(value.text)) return true;
  return entry.refuse(
      fmt::format("must consist of letters, digits, _ and -, got \"{}\"", value.text));
}

bool read(const Entry& entry, FilePath value) {
  if (!read(entry, value.text)) return false;
  if (value.text.empty()) return entry.refuse("must name a file, and is empty");
  value.text = (entry.reading.folder / value.text).lexically_normal().string();
  return true;
}

bool read(const Entry& entry, Choice value) {
  const int word = read_word(entry, value.known);
  if (word >= 0) value.value = word;
  return word >= 0;
}

bool read(const Entry& entry, MethodWord value) {
  const std::vector<Word> known = words_of(value.known);
  const int word = read_word(entry, known);
  if (word >= 0) value.word = known[word].text;
  return word >= 0;
}

bool read(const Entry& entry, Axis& value) {
  const int word = read_word(entry, words<Axis>);
  if (word < 0) return false;
  if (word >= entry.reading.dimension) {
    return entry.refuse("is \"z\", which does not exist in 2D", R"(use "x" or "y")");
  }
  value = static_cast<Axis>(word);
  return true;
}

bool read(const Entry& entry, AxisSet value) {
  const toml::array* list = entry.node.as_array();
  if (!list) return entry.refuse("must be a list of axes, found " + describe(entry.node));
  for (const toml::node& element : *list) {
    Axis axis{};
    if (!read(Entry{entry.key, element, entry.notes, entry.reading}, axis)) return false;
    value.axis[static_cast<std::size_t>(axis)] = true;
  }
  return true;
}

bool read(const Entry& entry, BodyName value) {
  return read_reference(entry, entry.reading.body_names, "body", value.index);
}

bool read(const Entry& entry, BodyPair value) {
  const toml::array* list = entry.node.as_array();
  if (!list || list->size() != value.indices.size()) {
    return entry.refuse("must be a list of two names of bodies, found " + describe(entry.node));
  }
  for (std::size_t i = 0; i < value.indices.size(); ++i) {
    const Entry element{entry.key, *list->get(i), entry.notes, entry.reading};
    if (!read(element, BodyName{value.indices[i]})) return false;
  }
  return true;
}

bool read(const Entry& entry, BoundaryName value) {
  return read_reference(entry, entry.reading.boundary_names, "boundary", value.index);
}

bool read(const Entry& entry, CutName value) {
  return read_reference(entry, entry.reading.cut_names, "cut", value.index);
}

bool read(const Entry& entry, MeasurementName value) {
  return read_reference(entry, entry.reading.measurement_names, "measurement", value.index);
}

bool read(const Entry& entry, MeasurementNames value) {
  const toml::array* list = entry.node.as_array();
  if (!list || list->empty()) {
    return entry.refuse("must be a list of names of measurements, found " + describe(entry.node));
  }
  value.indices.resize(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Entry element{entry.key, *list->get(i), entry.notes, entry.reading};
    if (!read(element, MeasurementName{value.indices[i]})) return false;
  }
  return true;
}

bool read(const Entry& entry, FieldName value) {
  if (!read(entry, value.field)) return false;
  std::vector<std::string_view> known;
  for (const MeasurableField& field : measurable_fields) {
    if (exists_in(field, entry.reading.dimension)) known.push_back(field.name);
  }
  if (std::find(known.begin(), known.end(), value.field) != known.end()) return true;
  return entry.refuse(fmt::format("names the field \"{}\", which does not exist", value.field),
                      suggestion(value.field, known, "there are"));
}

}  // namespace pliant
