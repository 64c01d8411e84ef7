#include <fmt/format.h>

#include <algorithm>

#include "engine/geometry/mesh_files/volume_mesh_file.hpp"
#include "engine/geometry/mesh_values.hpp"

// Gmsh, versions 2.2 and 4.1: sections $Name ... $EndName, of which $Nodes and $Elements are read.
// Version 2.2 has one row for each node (number, position) and element (number, kind, tags, nodes).
// Version 4.1 has blocks of nodes (numbers first, then positions) and of elements of one kind.
//
// Announced numbers of rows are not trusted: rows are read one by one, and a wrong number ends at
// the end of the file.
namespace pliant {
namespace {

struct Kind {
  int code, dimension, corners;
};

constexpr Kind kinds[] = {{1, 1, 2},   {2, 2, 3},   {3, 2, 4},   {4, 3, 4},   {5, 3, 8},
                          {6, 3, 6},   {7, 3, 5},   {8, 1, 3},   {9, 2, 6},   {10, 2, 9},
                          {11, 3, 10}, {12, 3, 27}, {13, 3, 18}, {14, 3, 14}, {15, 0, 1},
                          {16, 2, 8},  {17, 3, 20}};

const Kind& kind_of(const MeshValues& values, std::int64_t code) {
  for (const Kind& kind : kinds) {
    if (kind.code == code) return kind;
  }
  values.refuse(fmt::format("unknown kind {} of elements", code),
                "mesh the body with elements of order 1");
}

class Gmsh {
 public:
  Gmsh(const MeshFile& file, int dimension)
      : file_(file), version_(read_version()), rows_(file, dimension, is_text()) {}

  VolumeMesh operator()() {
    if (version_ == "2.2") {
      read_nodes_2();
      read_elements_2();
    } else {
      read_nodes_4();
      read_elements_4();
    }
    return rows_.mesh();
  }

 private:
  using Encoding = MeshValues::Encoding;

  bool is_text() const { return encoding_ == Encoding::text; }

  /// The start of the line after `$name`.
  std::size_t section(const std::string& name) const {
    const std::string mark = "$" + name;
    std::size_t found = file_.content.starts_with(mark) ? 0 : file_.content.find("\n" + mark);
    if (found == std::string::npos) {
      throw MeshError(fmt::format("{}: has no section ${}", file_.name, name),
                      std::string(save_again));
    }
    found = file_.content.find('\n', found + 1);
    return std::min(found, file_.content.size() - 1) + 1;
  }

  std::string read_version() {
    MeshText text(file_, section("MeshFormat"));
    std::string version(text.word_of_line());
    if (version != "2.2" && version != "4.1") {
      text.refuse(fmt::format("version {} of the format is not read", version),
                  "save it as version 2.2 or 4.1 (in Gmsh: -format msh41)");
    }
    if (text.integer(text.word_of_line(), "the file type") != 0)
      encoding_ = Encoding::little_endian;
    if (text.integer(text.word_of_line(), "the size of a number") != 8) {
      text.refuse("numbers have other than 8 bytes", std::string(save_again));
    }
    if (is_text()) return version;
    text.next_line();
    MeshValues one(file_, encoding_, text.offset());
    if (one.integer(4, "the number 1") != 1) {
      one.refuse("the file is big endian", "save it on a little-endian machine, or as text");
    }
    return version;
  }

  /// More rows than a section announces are an error too.
  void require_end(const MeshValues& values, const std::string& name) const {
    MeshText text(file_, values.offset());
    if (text.word() == "$End" + name) return;
    rows_.refuse(text.word_start(),
                 fmt::format("the section ${} has more rows than it announces", name),
                 std::string(save_again));
  }

  void require_sum(const MeshValues& values, std::int64_t left) const {
    if (left == 0) return;
    values.refuse("the blocks of a section do not have as many rows as the section announces",
                  std::string(save_again));
  }

  Vector position(MeshValues& values) const {
    Vector x;
    for (double& component : x) component = values.real(8, "a coordinate");
    return x;
  }

  /// In version 2.2 the number of rows is text, even in a binary file.
  MeshValues counted_section(const std::string& name, std::int64_t& count) const {
    MeshText text(file_, section(name));
    count = text.integer(text.word_of_line(), "the number of rows");
    text.next_line();
    return {file_, encoding_, text.offset()};
  }

  void read_nodes_2() {
    std::int64_t count = 0;
    MeshValues values = counted_section("Nodes", count);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t tag = values.integer(4, "the number of a node");
      const std::size_t start = values.start();
      rows_.add_node(start, tag, position(values));
    }
    require_end(values, "Nodes");
  }

  void read_elements_2() {
    std::int64_t count = 0;
    MeshValues values = counted_section("Elements", count);
    // In text, each element has its kind; in binary files, elements of one kind share a header.
    for (std::int64_t i = 0, run = 1; i < count; i += run) {
      std::int64_t code = 0, tags = 0;
      if (is_text()) {
        values.integer(4, "the number of an element");
        code = values.integer(4, "the kind of an element");
        tags = values.count(4, "the number of tags");
      } else {
        code = values.integer(4, "the kind of elements");
        run = std::max<std::int64_t>(values.count(4, "the number of elements"), 1);
        tags = values.count(4, "the number of tags");
      }
      const Kind& kind = kind_of(values, code);
      for (std::int64_t k = 0; k < run; ++k) {
        if (!is_text()) values.integer(4, "the number of an element");
        for (std::int64_t t = 0; t < tags; ++t) values.integer(4, "a tag");
        add_element(values, kind, 4);
      }
    }
    require_end(values, "Elements");
  }

  void add_element(MeshValues& values, const Kind& kind, int bytes) {
    const std::size_t row = values.start();
    std::int64_t corners[27];
    for (int k = 0; k < kind.corners; ++k)
      corners[k] = values.integer(bytes, "a node of an element");
    if (rows_.takes(row, kind.dimension, kind.corners, std::to_string(kind.code))) {
      rows_.add_element(row, corners);
    }
  }

  void read_nodes_4() {
    MeshValues values(file_, encoding_, section("Nodes"));
    const std::int64_t blocks = values.count(8, "the number of blocks");
    std::int64_t left = values.count(8, "the number of nodes");
    for (int k = 0; k < 2; ++k) values.integer(8, "a number of nodes");
    std::vector<std::int64_t> tags;
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = values.integer(4, "the dimension of an entity");
      values.integer(4, "the tag of an entity");
      const bool is_parametric = values.integer(4, "whether nodes are parametric") != 0;
      const std::int64_t count = values.count(8, "the number of nodes of a block");
      left -= count;
      tags.clear();
      for (std::int64_t i = 0; i < count; ++i) {
        tags.push_back(values.integer(8, "the number of a node"));
      }
      for (const std::int64_t tag : tags) {
        const Vector x = position(values);
        rows_.add_node(values.start(), tag, x);
        for (std::int64_t k = 0; is_parametric && k < dimension; ++k) values.real(8, "a parameter");
      }
    }
    require_sum(values, left);
    require_end(values, "Nodes");
  }

  void read_elements_4() {
    MeshValues values(file_, encoding_, section("Elements"));
    const std::int64_t blocks = values.count(8, "the number of blocks");
    std::int64_t left = values.count(8, "the number of elements");
    for (int k = 0; k < 2; ++k) values.integer(8, "a number of elements");
    for (std::int64_t b = 0; b < blocks; ++b) {
      values.integer(4, "the dimension of an entity");
      values.integer(4, "the tag of an entity");
      const Kind& kind = kind_of(values, values.integer(4, "the kind of elements"));
      const std::int64_t count = values.count(8, "the number of elements of a block");
      left -= count;
      for (std::int64_t i = 0; i < count; ++i) {
        values.integer(8, "the number of an element");
        add_element(values, kind, 8);
      }
    }
    require_sum(values, left);
    require_end(values, "Elements");
  }

  const MeshFile& file_;
  Encoding encoding_ = Encoding::text;
  std::string version_;
  VolumeMeshRows rows_;
};

}  // namespace

VolumeMesh read_gmsh(const MeshFile& file, int dimension) { return Gmsh(file, dimension)(); }

}  // namespace pliant
