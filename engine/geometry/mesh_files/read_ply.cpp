#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/geometry/mesh_files/mesh_file.hpp"

// PLY: a text header that declares elements and their properties, then the elements, as text or as
// bytes. Vertices have x, y and z, faces a list of vertices; everything else is skipped.
//
// The header is not trusted. Elements without properties are refused. Every announced element then
// takes at least one byte, so that a wrong number of elements ends at the end of the file.
namespace pliant {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  // type of the count of a list
};

struct Element {
  std::string name;
  std::size_t line = 0;  // offset of its declaration in the file
  std::int64_t count = 0;
  std::vector<Property> properties;

  bool has(std::string_view property) const {
    return std::any_of(properties.begin(), properties.end(),
                       [&](const Property& p) { return p.name == property && !p.count; });
  }
};

bool holds_corners(const Element& element, const Property& property) {
  return element.name == "face" && property.name.starts_with("vert") && property.count;
}

struct Header {
  std::optional<bool> is_text;  // empty before the line `format`
  std::vector<Element> elements;
  std::size_t end = 0;
};

Type type_of(const MeshText& text, std::string_view word) {
  constexpr std::pair<std::string_view, Type> known[] = {
      {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
      {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
      {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
      {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
  for (const auto& [name, type] : known) {
    if (name == word) return type;
  }
  text.refuse(fmt::format("unknown type \"{}\"", word), std::string(save_again));
}

Property read_property(MeshText& text) {
  const std::string_view first = text.word_of_line();
  if (first != "list") {
    const Type type = type_of(text, first);
    return {std::string(text.word_of_line()), type, std::nullopt};
  }
  const Type count = type_of(text, text.word_of_line());
  const Type type = type_of(text, text.word_of_line());
  return {std::string(text.word_of_line()), type, count};
}

bool read_format(MeshText& text) {
  const std::string_view format = text.word_of_line();
  if (format == "ascii") return true;
  if (format == "binary_little_endian") return false;
  text.refuse(fmt::format("the format \"{}\" is not read", format),
              "save it as ascii or binary_little_endian");
}

Element read_element(MeshText& text) {
  Element element;
  element.line = text.offset();
  element.name = text.word_of_line();
  element.count = text.integer(text.word_of_line(), "a number of elements");
  if (element.count < 0) text.refuse("a negative number of elements", std::string(save_again));
  return element;
}

void check_element(const MeshFile& file, const Element& element) {
  const auto refuse = [&](std::string_view what, std::string_view remedy) {
    file.refuse_line(element.line, fmt::format("the element \"{}\" {}", element.name, what),
                     std::string(remedy));
  };
  if (element.count == 0) return;
  if (element.properties.empty()) {
    refuse("has no properties", "declare its properties, or remove the element");
  }
  if (element.name == "vertex") {
    for (const char* axis : {"x", "y", "z"}) {
      if (!element.has(axis)) {
        refuse(fmt::format("has no property {}", axis), "export vertices with x, y and z");
      }
    }
  }
  const auto& properties = element.properties;
  if (element.name == "face" &&
      std::none_of(properties.begin(), properties.end(),
                   [&](const Property& p) { return holds_corners(element, p); })) {
    refuse("has no list of vertices", "export faces with the list vertex_indices");
  }
}

void check_header(const MeshFile& file, const Header& header) {
  if (!header.is_text) {
    file.refuse_line(0, "the header has no line `format`", std::string(save_again));
  }
  for (const Element& element : header.elements) check_element(file, element);
}

Header read_header(const MeshFile& file) {
  Header header;
  MeshText text(file);
  if (text.word_of_line() != "ply") {
    text.refuse("this is not a PLY file, which begins with the line `ply`",
                std::string(save_again));
  }
  while (text.next_line()) {
    const std::string_view key = text.word_of_line();
    if (key == "format") {
      header.is_text = read_format(text);
    } else if (key == "element") {
      header.elements.push_back(read_element(text));
    } else if (key == "property") {
      if (header.elements.empty()) {
        text.refuse("a property stands before the first element", std::string(save_again));
      }
      header.elements.back().properties.push_back(read_property(text));
    } else if (key == "end_header") {
      text.next_line();
      header.end = text.offset();
      check_header(file, header);
      return header;
    }
  }
  file.refuse_end(file.content.size(), "its `end_header`");
}

class Body {
 public:
  Body(const MeshFile& file, const Header& header)
      : file_(file), header_(header), text_(file, header.end), at_(header.end) {}

  SurfaceMesh operator()() {
    for (const Element& element : header_.elements) {
      for (index_ = 0; index_ < element.count; ++index_) {
        if (element.name == "vertex") mesh_.vertices.emplace_back();
        for (const Property& property : element.properties) read(element, property);
      }
    }
    return std::move(mesh_);
  }

 private:
  void read(const Element& element, const Property& property) {
    if (property.count) return read_list(element, property);
    const double value = next(element, property.type);
    const std::size_t axis = std::string_view("xyz").find(property.name);
    const bool is_axis = property.name.size() == 1 && axis != std::string_view::npos;
    if (element.name != "vertex" || !is_axis) return;
    if (!std::isfinite(value)) refuse("is not finite", "remove it, or give it a place");
    mesh_.vertices.back()[axis] = value;
  }

  void read_list(const Element& element, const Property& property) {
    const double count = next(element, *property.count);
    if (!(count >= 0)) refuse("has a list of negative length", std::string(save_again));
    if (!is_whole(count)) {
      refuse(fmt::format("has a list of {} values", count), std::string(save_again));
    }
    const bool is_face = holds_corners(element, property);
    corners_.clear();
    for (double i = 0; i < count; ++i) {
      const double corner = next(element, property.type);
      if (is_face) add_corner(corner);
    }
    if (!is_face) return;
    if (corners_.size() < 3) {
      refuse(fmt::format("has {} vertices", corners_.size()),
             "give it three or more, or remove it");
    }
    add_fan(mesh_, corners_);
  }

  void add_corner(double corner) {
    const std::size_t count = mesh_.vertices.size();
    if (!(corner >= 0 && corner < static_cast<double>(count) && is_whole(corner))) {
      refuse(fmt::format("has the vertex {}, of {}", corner, count),
             "count vertices from 0, and put them before the faces");
    }
    corners_.push_back(static_cast<std::int32_t>(corner));
  }

  static bool is_whole(double value) { return value == std::floor(value); }

  double next(const Element& element, Type type) {
    element_ = &element;
    if (*header_.is_text) {
      const std::string_view word = text_.word();
      if (word.empty()) refuse_end();
      return text_.number(word, fmt::format("a value of {} {}", element.name, index_));
    }
    switch (type) {
      case Type::i8:
        return take<std::int8_t>();
      case Type::u8:
        return take<std::uint8_t>();
      case Type::i16:
        return take<std::int16_t>();
      case Type::u16:
        return take<std::uint16_t>();
      case Type::i32:
        return take<std::int32_t>();
      case Type::u32:
        return take<std::uint32_t>();
      case Type::f32:
        return take<float>();
      case Type::f64:
        break;
    }
    return take<double>();
  }

  template <class Value>
  double take() {
    if (file_.content.size() - at_ < sizeof(Value)) refuse_end();
    const auto value = value_at<Value>(file_.content.data() + at_);
    at_ += sizeof(Value);
    return static_cast<double>(value);
  }

  [[noreturn]] void refuse_end() const {
    file_.refuse_end(file_.content.size(), fmt::format("{} {} of the {} that it announces",
                                                       element_->name, index_, element_->count));
  }

  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    const std::string sentence = fmt::format("{} {} {}", element_->name, index_, what);
    if (*header_.is_text) text_.refuse(sentence, remedy);
    file_.refuse_byte(at_, sentence, remedy);
  }

  const MeshFile& file_;
  const Header& header_;
  MeshText text_;
  std::size_t at_;
  std::int64_t index_ = 0;
  const Element* element_ = nullptr;
  std::vector<std::int32_t> corners_;
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh read_ply(const MeshFile& file) {
  const Header header = read_header(file);
  return Body(file, header)();
}

}  // namespace pliant
