#include "engine/output/results/xdmf.hpp"

#include <fmt/format.h>

#include <iterator>

namespace pliant {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

const char* attribute_type(const StoredField& field) {
  if (field.components == 1) return "Scalar";
  return field.components == 3 ? "Vector" : "Matrix";
}

}  // namespace

XdmfSeries::XdmfSeries(const std::string& file_name, std::string grid)
    : file_name_(escaped(file_name)), grid_(std::move(grid)) {}

/// Rows of an array: start, stride, count, and the shape of the whole array. That shape grows with
/// every frame; the shape up to the end of this frame is enough for readers.
std::string XdmfSeries::slab(const std::string& path, const Rows& rows, const StoredField& field) {
  const auto [first, n] = rows;
  const auto k = field.components;
  const auto kind = fmt::format(R"(Format="HDF" NumberType="{}" Precision="{}")",
                                field.integer ? "Int" : "Float", field.bytes);
  if (k == 1)
    return fmt::format(R"(<DataItem {} Dimensions="{}">{}|{}:1:{}:{}</DataItem>)", kind, n, path,
                       first, n, first + n);
  return fmt::format(R"(<DataItem {} Dimensions="{} {}">{}|{} 0:1 1:{} {}:{} {}</DataItem>)", kind,
                     n, k, path, first, n, k, first + n, k);
}

void XdmfSeries::add_particles(const FrameSpan& frame, const StoredField& position,
                               const std::vector<StoredField>& fields) {
  const auto root = file_name_ + ":/VTKHDF/";
  const StoredField vertex{"", 1, true, 8};
  const auto topology = fmt::format(
      R"(TopologyType="Polyvertex" NodesPerElement="1" NumberOfElements="{}">
          {})",
      frame.particles, slab(root + "Vertices/Connectivity", {0, frame.particles}, vertex));
  add(frame.time, topology, root, {frame.first, frame.particles}, position, fields);
}

void XdmfSeries::add_surface(double time, const SurfaceSpan& span, int corners,
                             const StoredField& position, const std::vector<StoredField>& fields) {
  if (span.pieces == 0) return;
  const auto root = file_name_ + ":/surface/";
  const StoredField vertex{"", corners, true, 8};
  const auto topology = fmt::format(
      R"({} NumberOfElements="{}">
          {})",
      corners == 2 ? R"(TopologyType="Polyline" NodesPerElement="2")"
                   : R"(TopologyType="Triangle")",
      span.pieces, slab(root + "Connectivity", {span.first_piece, span.pieces}, vertex));
  add(time, topology, root, {span.first_vertex, span.vertices}, position, fields);
}

void XdmfSeries::add(double time, const std::string& topology, const std::string& root,
                     const Rows& points, const StoredField& position,
                     const std::vector<StoredField>& fields) {
  auto out = std::back_inserter(frames_);
  fmt::format_to(out,
                 R"(      <Grid Name="{}">
        <Time Value="{}"/>
        <Topology {}
        </Topology>
        <Geometry GeometryType="XYZ">
          {}
        </Geometry>
)",
                 grid_, time, topology, slab(root + "Points", points, position));
  for (const auto& field : fields) {
    const auto name = escaped(field.name);
    fmt::format_to(out,
                   R"(        <Attribute Name="{}" AttributeType="{}" Center="Node">
          {}
        </Attribute>
)",
                   name, attribute_type(field), slab(root + "PointData/" + name, points, field));
  }
  frames_ += "      </Grid>\n";
}

std::string XdmfSeries::text() const {
  return R"(<?xml version="1.0"?>
<Xdmf Version="3.0">
  <Domain>
    <Grid Name="run" GridType="Collection" CollectionType="Temporal">
)" + frames_ +
         R"(    </Grid>
  </Domain>
</Xdmf>
)";
}

}  // namespace pliant
