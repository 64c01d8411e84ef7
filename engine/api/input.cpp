#include <pliant/error.hpp>
#include <pliant/input.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <span>
#include <string_view>
#include <utility>

namespace pliant {

namespace {

using enum Input::Kind;

constexpr std::string_view header = "time,input,name,x1,y1,z1,x2,y2,z2";
constexpr std::pair<std::string_view, Input::Kind> kinds[] = {
    {"advance", advance}, {"pressure", pressure}, {"wall_velocity", wall_velocity},
    {"blade", blade},     {"lift", lift},
};

/// How many numbers a kind of input has.
int numbers_of(Input::Kind kind) {
  constexpr int of_kind[] = {1, 1, 3, 6, 0};
  return of_kind[static_cast<int>(kind)];
}

/// A row of a session, with its place in the file for messages.
class Row {
 public:
  Row(const std::filesystem::path& file, int line, const std::string& text)
      : place_(fmt::format("{}:{}", file.string(), line)) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      fields_.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
    fields_.resize(std::max<std::size_t>(fields_.size(), 9));
  }

  Input input() const {
    Input input;
    input.kind = kind();
    input.time = number(0);
    input.name = fields_[2];
    if (input.kind != advance && input.name.empty()) {
      throw InputError(
          fmt::format("{}: `{}` lacks a name; give that of a boundary or a cut of the "
                      "case",
                      place_, fields_[1]));
    }
    const int count = numbers_of(input.kind);
    if (count == 1) (input.kind == advance ? input.until : input.value) = number(3);
    for (int a = 0; count > 1 && a < 3; ++a) input.first[a] = number(3 + a);
    for (int a = 0; count > 3 && a < 3; ++a) input.second[a] = number(6 + a);
    return input;
  }

  const std::string& place() const { return place_; }

 private:
  Input::Kind kind() const {
    for (const auto& [word, kind] : kinds) {
      if (fields_[1] == word) return kind;
    }
    throw InputError(
        fmt::format("{}: unknown input `{}`; write advance, pressure, wall_velocity, blade or lift",
                    place_, fields_[1]));
  }

  double number(std::size_t field) const {
    const std::string& text = fields_[field];
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && !std::isnan(value)) {
      return value;
    }
    throw InputError(
        fmt::format("{}: column {} must be a number, got `{}`", place_, field + 1, text));
  }

  std::string place_;
  std::vector<std::string> fields_;
};

std::string row_of(const Input& input) {
  std::string row =
      fmt::format("{},{},{}", input.time, kinds[static_cast<int>(input.kind)].first, input.name);
  const int count = numbers_of(input.kind);
  if (count == 1) row += fmt::format(",{}", input.kind == advance ? input.until : input.value);
  if (count > 1) row += fmt::format(",{}", fmt::join(input.first, ","));
  if (count > 3) row += fmt::format(",{}", fmt::join(input.second, ","));
  return row;
}

}  // namespace

std::vector<Input> read_inputs(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw InputError(
        fmt::format("{}: cannot be read; give the path of a session (CSV)", file.string()));
  }
  std::vector<Input> inputs;
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    if (text.ends_with('\r')) text.pop_back();
    if (line == 1) {
      if (text == header) continue;
      throw InputError(
          fmt::format("{}:1: not a session; its first line must be `{}`", file.string(), header));
    }
    if (text.empty()) continue;
    const Row row(file, line, text);
    inputs.push_back(row.input());
    if (inputs.size() > 1 && inputs.back().time < inputs[inputs.size() - 2].time) {
      throw InputError(fmt::format("{}: t = {} comes after t = {}; sort the rows by time",
                                   row.place(), inputs.back().time,
                                   inputs[inputs.size() - 2].time));
    }
  }
  return inputs;
}

void write_inputs(const std::filesystem::path& file, const std::vector<Input>& inputs) {
  std::ofstream stream(file);
  stream << header << '\n';
  for (const Input& input : inputs) stream << row_of(input) << '\n';
  if (!stream.flush()) throw RunError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace pliant
