#include "engine/output/results/frame_store.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <stdexcept>

#include "engine/output/hdf5/commit_driver.hpp"

// Layout of the file (F frames, N particles of all frames, n particles of the largest frame):
//
//    /VTKHDF                     Version = 2, 0; Type = PolyData
//      Points                    [N][3]
//      PointData/<field>         [N] or [N][component], attribute unit
//      NumberOfPoints            [F]       = Vertices/NumberOfCells, .../NumberOfConnectivityIds
//      Vertices/Offsets          [N + F]   0 ... particles of the frame, frame after frame
//      Vertices/Connectivity     [n]       0, 1, 2, ...: shared by all frames
//      Lines = Polygons = Strips           empty, but required by the format
//        NumberOfCells           [F]       0, = NumberOfConnectivityIds = Offsets = Connectivity
//      Steps                     NSteps = F
//        Values                  [F]       time, = /frames/time
//        PartOffsets, NumberOfParts, PointOffsets [F]; CellOffsets, ConnectivityIdOffsets [F][4]
//        PointDataOffsets/<field>          = PointOffsets
//    /frames/step                [F]
//
// "=" is a hard link: one array with several names. Offsets are written for every frame, although
// all are a beginning of the longest. Readers before VTK 9.4 find the offsets of a frame by
// counting all cells and frames before it, whatever CellOffsets says.

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::GrowingArray;

constexpr int topologies = 4;  ///< vertices, lines, polygons, strips

/// Creates a second name for `old_name` of a group.
void link(hid_t group, const std::string& name, hid_t old_group, const std::string& old_name) {
  checked(
      H5Lcreate_hard(old_group, old_name.c_str(), group, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
      "link " + name);
}

void check(const Frame& frame) {
  const auto particles = frame.position.size() / 3;
  if (particles == 0 || frame.position.size() % 3 != 0)
    throw std::invalid_argument("a frame needs positions [particle][3] of at least one particle");
  check_fields(frame.fields, particles);
}

}  // namespace

FrameStore::FrameStore(hid_t file) : file_(file) {
  if (hdf5::exists(file_, "VTKHDF")) open();
}

void FrameStore::create(const Frame& first) {
  const auto rows = chunk_rows_for(first.position.size() / 3);
  const auto reals = hdf5::real_type(first.real_bytes), times = hdf5::type_of<double>(),
             counts = hdf5::type_of<std::int64_t>();
  root_ = hdf5::create_group(file_, "VTKHDF");
  hdf5::write_attribute(root_, "Version", std::vector{2, 0});
  hdf5::write_attribute(root_, "Type", "PolyData");
  points_ = GrowingArray::create(root_, "Points", reals, 3, rows);
  particles_ = GrowingArray::create(root_, "NumberOfPoints", counts, 0, frame_chunk_rows);

  const auto vertices = hdf5::create_group(root_, "Vertices");
  offset_ = GrowingArray::create(vertices, "Offsets", counts, 0, rows);
  connectivity_ = GrowingArray::create(vertices, "Connectivity", counts, 0, rows);
  link(vertices, "NumberOfCells", root_, "NumberOfPoints");
  link(vertices, "NumberOfConnectivityIds", root_, "NumberOfPoints");
  const auto lines = hdf5::create_group(root_, "Lines");
  none_ = GrowingArray::create(lines, "NumberOfCells", counts, 0, frame_chunk_rows);
  for (const auto* name : {"NumberOfConnectivityIds", "Offsets", "Connectivity"})
    link(lines, name, lines, "NumberOfCells");
  link(root_, "Polygons", root_, "Lines");
  link(root_, "Strips", root_, "Lines");

  steps_ = hdf5::create_group(root_, "Steps");
  hdf5::write_attribute(steps_, "NSteps", 0);
  time_ = GrowingArray::create(steps_, "Values", times, 0, frame_chunk_rows);
  part_ = GrowingArray::create(steps_, "PartOffsets", counts, 0, frame_chunk_rows);
  parts_ = GrowingArray::create(steps_, "NumberOfParts", counts, 0, frame_chunk_rows);
  first_ = GrowingArray::create(steps_, "PointOffsets", counts, 0, frame_chunk_rows);
  cells_ = GrowingArray::create(steps_, "CellOffsets", counts, topologies, frame_chunk_rows);
  connections_ =
      GrowingArray::create(steps_, "ConnectivityIdOffsets", counts, topologies, frame_chunk_rows);
  const auto field_offsets = hdf5::create_group(steps_, "PointDataOffsets");
  const auto point_data = hdf5::create_group(root_, "PointData");
  values_.create(point_data, first.fields, first.real_bytes, rows);
  for (const auto& field : fields()) link(field_offsets, field.name, steps_, "PointOffsets");

  const auto frames = hdf5::create_group(file_, "frames");
  step_ = GrowingArray::create(frames, "step", counts, 0, frame_chunk_rows);
  link(frames, "time", steps_, "Values");
}

void FrameStore::open() {
  root_ = hdf5::open_group(file_, "VTKHDF");
  points_ = GrowingArray::open(root_, "Points");
  particles_ = GrowingArray::open(root_, "NumberOfPoints");
  offset_ = GrowingArray::open(root_, "Vertices/Offsets");
  connectivity_ = GrowingArray::open(root_, "Vertices/Connectivity");
  none_ = GrowingArray::open(root_, "Lines/NumberOfCells");
  steps_ = hdf5::open_group(root_, "Steps");
  time_ = GrowingArray::open(steps_, "Values");
  part_ = GrowingArray::open(steps_, "PartOffsets");
  parts_ = GrowingArray::open(steps_, "NumberOfParts");
  first_ = GrowingArray::open(steps_, "PointOffsets");
  cells_ = GrowingArray::open(steps_, "CellOffsets");
  connections_ = GrowingArray::open(steps_, "ConnectivityIdOffsets");
  step_ = GrowingArray::open(file_, "frames/step");
  values_.open(hdf5::open_group(root_, "PointData"));

  std::vector<double> time(time_.rows());
  std::vector<std::int64_t> particles(particles_.rows());
  time_.read(time.data());
  particles_.read(particles.data());
  std::uint64_t first = 0;
  const auto frames = static_cast<std::size_t>(hdf5::read_attribute(steps_, "NSteps"));
  for (std::size_t f = 0; f < frames; ++f) {
    const auto count = static_cast<std::uint64_t>(particles.at(f));
    frames_.push_back({time.at(f), first, count});
    first += count;
  }
}

// The count that makes a frame valid is committed last.
void FrameStore::append(const Frame& frame) {
  check(frame);
  if (!root_.valid()) create(frame);
  append_particles(frame);
  append_step(frame);
  hdf5::flush(file_);
  const auto particles = frame.position.size() / 3;
  const auto first = frames_.empty() ? 0 : frames_.back().first + frames_.back().particles;
  hdf5::overwrite_attribute(steps_, "NSteps", static_cast<int>(frames_.size() + 1));
  hdf5::flush(file_);
  frames_.push_back({frame.time, first, particles});
}

void FrameStore::append_particles(const Frame& frame) {
  const auto particles = frame.position.size() / 3;
  values_.append(frame.fields, particles);
  points_.append(frame.position.data(), particles);

  std::vector<std::int64_t> count(particles + 1);
  std::iota(count.begin(), count.end(), 0);
  offset_.append(count.data(), count.size());
  const auto connected = connectivity_.rows();
  if (connected < particles) connectivity_.append(count.data() + connected, particles - connected);
}

void FrameStore::append_step(const Frame& frame) {
  const auto end = frames_.empty() ? 0 : frames_.back().first + frames_.back().particles;
  const auto first = static_cast<std::int64_t>(end);
  const auto particles = static_cast<std::int64_t>(frame.position.size() / 3);
  const auto part = static_cast<std::int64_t>(frames_.size());
  const std::int64_t one = 1;
  const std::array<std::int64_t, topologies> cells = {first}, zeros = {};
  time_.append(&frame.time, 1);
  step_.append(&frame.step, 1);
  part_.append(&part, 1);
  parts_.append(&one, 1);
  first_.append(&first, 1);
  cells_.append(cells.data(), 1);
  connections_.append(zeros.data(), 1);
  none_.append(zeros.data(), 1);
  particles_.append(&particles, 1);
}

// The reverse of append: first the count decreases, then the arrays are cut. This also cuts arrays
// that a dying process has already extended for an uncounted frame.
void FrameStore::truncate(std::size_t frames) {
  if (!root_.valid()) return;
  frames_.resize(std::min(frames, frames_.size()));
  const auto count = frames_.size();
  hdf5::overwrite_attribute(steps_, "NSteps", static_cast<int>(count));
  hdf5::flush(file_);
  const auto end = count == 0 ? 0 : frames_.back().first + frames_.back().particles;
  std::uint64_t most = 0;
  for (const auto& frame : frames_) most = std::max(most, frame.particles);
  for (auto* array :
       {&time_, &step_, &particles_, &part_, &parts_, &first_, &cells_, &connections_, &none_})
    array->truncate(count);
  points_.truncate(end);
  values_.truncate(end);
  offset_.truncate(end + count);
  connectivity_.truncate(most);
  hdf5::flush(file_);
}

}  // namespace pliant
