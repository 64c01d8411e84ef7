#include "engine/output/xdmf.hpp"

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

/// Rows [first, first + count) of an array: start, stride, count, and the shape it is cut from. The
/// true shape grows with every frame; as far as this frame's end is enough for the reader.
std::string slab(const std::string& path, const FrameSpan& frame, const StoredField& field) {
  const auto n = frame.particles, first = frame.first;
  const auto k = field.components;
  const auto kind = fmt::format(R"(Format="HDF" NumberType="{}" Precision="{}")",
                                field.integer ? "Int" : "Float", field.bytes);
  if (k == 1)
    return fmt::format(R"(<DataItem {} Dimensions="{}">{}|{}:1:{}:{}</DataItem>)", kind, n, path,
                       first, n, first + n);
  return fmt::format(R"(<DataItem {} Dimensions="{} {}">{}|{} 0:1 1:{} {}:{} {}</DataItem>)", kind,
                     n, k, path, first, n, k, first + n, k);
}

const char* attribute_type(const StoredField& field) {
  if (field.components == 1) return "Scalar";
  return field.components == 3 ? "Vector" : "Matrix";
}

}  // namespace

XdmfSeries::XdmfSeries(const std::string& file_name) : file_name_(escaped(file_name)) {}

void XdmfSeries::add(const FrameSpan& frame, const std::vector<StoredField>& fields) {
  auto out = std::back_inserter(frames_);
  const StoredField connectivity{"", 1, true, 8}, points{"", 3, false, 8};
  const FrameSpan vertices{frame.time, 0, frame.particles};
  const auto root = file_name_ + ":/VTKHDF/";
  fmt::format_to(out,
                 R"(      <Grid Name="particles">
        <Time Value="{}"/>
        <Topology TopologyType="Polyvertex" NodesPerElement="1" NumberOfElements="{}">
          {}
        </Topology>
        <Geometry GeometryType="XYZ">
          {}
        </Geometry>
)",
                 frame.time, frame.particles,
                 slab(root + "Vertices/Connectivity", vertices, connectivity),
                 slab(root + "Points", frame, points));
  for (const auto& field : fields) {
    const auto name = escaped(field.name);
    fmt::format_to(out,
                   R"(        <Attribute Name="{}" AttributeType="{}" Center="Node">
          {}
        </Attribute>
)",
                   name, attribute_type(field), slab(root + "PointData/" + name, frame, field));
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
