#include <fmt/format.h>

#include "engine/geometry/mesh_files/volume_mesh_file.hpp"
#include "engine/geometry/mesh_values.hpp"

// Legacy VTK: four lines (version, title, ASCII or BINARY, DATASET UNSTRUCTURED_GRID), then
// sections that start with a keyword. POINTS, CELLS and CELL_TYPES are read, in this order. Up to
// version 4, a cell is a row with its number of corners and the corners. From 5.1 on, there are two
// lists, OFFSETS and CONNECTIVITY. Binary numbers are big endian.
namespace pliant {
namespace {

/// Dimension of a kind of cell; linear kinds come first, then quadratic ones.
int dimension_of(const MeshValues& values, std::int64_t kind) {
  constexpr int linear[] = {0, 0, 0, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3};
  if (kind >= 0 && kind <= 14) return linear[kind];
  if (kind == 21) return 1;
  if (kind == 22 || kind == 23) return 2;
  if (kind == 24 || kind == 25) return 3;
  values.refuse(fmt::format("unknown kind {} of cells", kind),
                "mesh the body with elements of order 1");
}

class Vtk {
 public:
  Vtk(const MeshFile& file, int dimension)
      : file_(file),
        dimension_(dimension),
        text_(file),
        is_text_(read_header()),
        rows_(file, dimension, is_text_) {}

  VolumeMesh operator()() {
    while (text_.next_line()) {
      const std::string_view key = text_.word_of_line();
      if (key == "POINTS") {
        read_points();
      } else if (key == "CELLS") {
        read_cells();
      } else if (key == "CELL_TYPES") {
        read_kinds();
        return rows_.mesh();
      }
    }
    file_.refuse_end(file_.content.size(), "its `CELL_TYPES`");
  }

 private:
  bool read_header() {
    if (!file_.content.starts_with("# vtk DataFile Version ")) {
      text_.refuse("this is not a legacy VTK file, which begins with `# vtk DataFile Version`",
                   std::string(save_again));
    }
    text_.next_line();
    text_.next_line();
    const std::string_view encoding = text_.word_of_line();
    if (encoding != "ASCII" && encoding != "BINARY") {
      text_.refuse(fmt::format("the third line must be ASCII or BINARY, found \"{}\"", encoding),
                   std::string(save_again));
    }
    text_.next_line();
    const std::string_view dataset = text_.word_of_line(), kind = text_.word_of_line();
    if (dataset != "DATASET" || kind != "UNSTRUCTURED_GRID") {
      text_.refuse(fmt::format("the data set \"{}\" is not read", kind),
                   "save it as an unstructured grid");
    }
    return encoding == "ASCII";
  }

  MeshValues values() {
    text_.next_line();
    return {file_, is_text_ ? MeshValues::Encoding::text : MeshValues::Encoding::big_endian,
            text_.offset()};
  }

  std::int64_t count(std::string_view what) {
    const std::int64_t count = text_.integer(text_.word_of_line(), what);
    if (count < 0) text_.refuse(fmt::format("{} is {}", what, count), std::string(save_again));
    return count;
  }

  /// Bytes of a number of the type named in this line.
  int width(std::string_view narrow, std::string_view wide) {
    const std::string_view type = text_.word_of_line();
    if (type == narrow) return 4;
    if (type == wide) return 8;
    text_.refuse(fmt::format("numbers of the type \"{}\" are not read", type),
                 fmt::format("save them as {}", wide));
  }

  /// Continues with the text after the values of a section.
  void go_on(const MeshValues& values) { text_ = MeshText(file_, values.offset()); }

  void read_points() {
    const std::int64_t points = count("the number of points");
    const int bytes = width("float", "double");
    MeshValues from = values();
    for (std::int64_t i = 0; i < points; ++i) {
      Vector x;
      for (double& component : x) component = from.real(bytes, "a coordinate");
      rows_.add_node(from.start(), i, x);
    }
    go_on(from);
  }

  void read_cells() {
    const std::int64_t first = count("the number of cells"),
                       second = count("the number of corners");
    const std::size_t here = text_.offset();
    text_.next_line();
    MeshText ahead(file_, text_.offset());
    if (ahead.word_of_line() == "OFFSETS") return read_offsets(first, second);
    text_ = MeshText(file_, here);
    MeshValues from = values();
    for (std::int64_t i = 0; i < first; ++i) {
      const std::int64_t corners = from.count(4, "the number of corners of a cell");
      starts_.push_back(corners_.size());
      for (std::int64_t k = 0; k < corners; ++k) add_corner(from, 4);
    }
    starts_.push_back(corners_.size());
    go_on(from);
  }

  void read_offsets(std::int64_t offsets, std::int64_t corners) {
    text_.word_of_line();
    MeshValues from = offset_values();
    for (std::int64_t i = 0; i < offsets; ++i) {
      const std::int64_t start = from.count(bytes_, "an offset");
      const bool is_ordered = starts_.empty() || starts_.back() <= static_cast<std::size_t>(start);
      if (!is_ordered || start > corners) {
        from.refuse(fmt::format("the offset {} is out of order", start), std::string(save_again));
      }
      starts_.push_back(static_cast<std::size_t>(start));
    }
    go_on(from);
    text_.next_line();
    if (text_.word_of_line() != "CONNECTIVITY") {
      text_.refuse("CONNECTIVITY must follow the offsets", std::string(save_again));
    }
    from = offset_values();
    for (std::int64_t i = 0; i < corners; ++i) add_corner(from, bytes_);
    go_on(from);
  }
  MeshValues offset_values() {
    bytes_ = width("vtktypeint32", "vtktypeint64");
    return values();
  }

  void add_corner(MeshValues& from, int bytes) {
    corners_.push_back(from.integer(bytes, "a corner of a cell"));
    corner_at_.push_back(from.start());
  }

  void read_kinds() {
    const std::int64_t cells = count("the number of kinds");
    const auto expected = static_cast<std::int64_t>(starts_.empty() ? 0 : starts_.size() - 1);
    if (cells != expected) {
      text_.refuse(fmt::format("{} kinds of cells follow {} cells", cells, expected),
                   std::string(save_again));
    }
    MeshValues from = values();
    for (std::int64_t i = 0; i < cells; ++i) {
      const std::int64_t kind = from.integer(4, "the kind of a cell");
      const std::size_t start = starts_[i], corners = starts_[i + 1] - start;
      const int cell_dimension = dimension_of(from, kind);
      const std::size_t row = corners == 0 ? from.start() : corner_at_[start];
      const int simplex = dimension_ == 3 ? 10 : 5;
      const bool is_simplex =
          kind == simplex && corners == static_cast<std::size_t>(dimension_) + 1;
      if (rows_.takes(row, cell_dimension, is_simplex ? dimension_ + 1 : -1,
                      std::to_string(kind))) {
        rows_.add_element(row, &corners_[start]);
      }
    }
  }

  const MeshFile& file_;
  int dimension_;
  MeshText text_;
  bool is_text_;
  VolumeMeshRows rows_;
  int bytes_ = 4;                       ///< of an offset
  std::vector<std::size_t> starts_;     ///< [cell] its first corner; one more entry than cells
  std::vector<std::int64_t> corners_;   ///< of all cells
  std::vector<std::size_t> corner_at_;  ///< their offsets in the file
};

}  // namespace

VolumeMesh read_vtk(const MeshFile& file, int dimension) { return Vtk(file, dimension)(); }

}  // namespace pliant
