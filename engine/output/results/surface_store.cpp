#include "engine/output/results/surface_store.hpp"

#include <algorithm>
#include <stdexcept>

namespace pliant {
namespace {

using hdf5::GrowingArray;

void check(const FrameSurface& surface) {
  const auto vertices = surface.position.size() / 3;
  const auto in_range = [vertices](std::int64_t v) {
    return v >= 0 && static_cast<std::size_t>(v) < vertices;
  };
  if (surface.position.size() % 3 != 0 || surface.corners < 2 ||
      surface.vertex.size() % static_cast<std::size_t>(surface.corners) != 0 ||
      !std::ranges::all_of(surface.vertex, in_range))
    throw std::invalid_argument("a surface needs positions [vertex][3] and pieces of its vertices");
  check_fields(surface.fields, vertices);
}

}  // namespace

SurfaceStore::SurfaceStore(hid_t file) : file_(file) {
  if (hdf5::exists(file_, "surface")) open();
}

void SurfaceStore::create(const FrameSurface& first, int real_bytes) {
  const auto rows = chunk_rows_for(first.position.size() / 3);
  const auto reals = hdf5::real_type(real_bytes), counts = hdf5::type_of<std::int64_t>();
  root_ = hdf5::create_group(file_, "surface");
  points_ = GrowingArray::create(root_, "Points", reals, 3, rows);
  connectivity_ = GrowingArray::create(root_, "Connectivity", counts, first.corners, rows);
  vertices_ = GrowingArray::create(root_, "NumberOfPoints", counts, 0, frame_chunk_rows);
  pieces_ = GrowingArray::create(root_, "NumberOfCells", counts, 0, frame_chunk_rows);
  values_.create(hdf5::create_group(root_, "PointData"), first.fields, real_bytes, rows);
}

void SurfaceStore::open() {
  root_ = hdf5::open_group(file_, "surface");
  points_ = GrowingArray::open(root_, "Points");
  connectivity_ = GrowingArray::open(root_, "Connectivity");
  vertices_ = GrowingArray::open(root_, "NumberOfPoints");
  pieces_ = GrowingArray::open(root_, "NumberOfCells");
  values_.open(hdf5::open_group(root_, "PointData"));
  std::vector<std::int64_t> vertices(vertices_.rows()), pieces(pieces_.rows());
  vertices_.read(vertices.data());
  pieces_.read(pieces.data());
  for (std::size_t f = 0; f < std::min(vertices.size(), pieces.size()); ++f) {
    SurfaceSpan span = next();
    span.vertices = static_cast<std::uint64_t>(vertices[f]);
    span.pieces = static_cast<std::uint64_t>(pieces[f]);
    spans_.push_back(span);
  }
}

/// An empty span after the last one.
SurfaceSpan SurfaceStore::next() const {
  if (spans_.empty()) return {0, 0, 0, 0};
  const SurfaceSpan& last = spans_.back();
  return {last.first_vertex + last.vertices, 0, last.first_piece + last.pieces, 0};
}

void SurfaceStore::append(const FrameSurface& surface, int real_bytes) {
  check(surface);
  if (!root_.valid()) create(surface, real_bytes);
  if (surface.corners != corners())
    throw std::invalid_argument("a surface has other pieces than the earlier ones");
  SurfaceSpan span = next();
  span.vertices = surface.position.size() / 3;
  span.pieces = surface.vertex.size() / static_cast<std::size_t>(surface.corners);
  values_.append(surface.fields, span.vertices);
  points_.append(surface.position.data(), span.vertices);
  connectivity_.append(surface.vertex.data(), span.pieces);
  const auto vertices = static_cast<std::int64_t>(span.vertices);
  const auto pieces = static_cast<std::int64_t>(span.pieces);
  vertices_.append(&vertices, 1);
  pieces_.append(&pieces, 1);
  spans_.push_back(span);
}

void SurfaceStore::truncate(std::size_t frames) {
  if (!root_.valid()) return;
  spans_.resize(std::min(frames, spans_.size()));
  const SurfaceSpan end = next();
  vertices_.truncate(spans_.size());
  pieces_.truncate(spans_.size());
  connectivity_.truncate(end.first_piece);
  points_.truncate(end.first_vertex);
  values_.truncate(end.first_vertex);
}

}  // namespace pliant
