#include "engine/report/run_reader.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "engine/output/error.hpp"
#include "engine/output/hdf5/hdf5.hpp"
#include "engine/output/results/surface_store.hpp"
#include "engine/report/nearest_values.hpp"

namespace pliant::report {
namespace {

using hdf5::GrowingArray;
using hdf5::Handle;

constexpr int particle = 1;  ///< value of the field `kind`; others are ghosts
constexpr auto remedy =
    "the file is damaged or was not written by pliant; run the case again, or take a copy";

Handle open_file(const std::filesystem::path& path) {
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open the file"};
}

/// The scalar of each row of a field.
std::vector<float> read_scalar(hid_t group, const Scalar& scalar, hsize_t first, hsize_t count) {
  const auto array = GrowingArray::open(group, scalar.field);
  const auto width = static_cast<std::size_t>(std::max(1, array.components()));
  std::vector<float> components(count * width), values(count);
  array.read(components.data(), first, count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = value_of(scalar, components.data() + i * width);
  }
  return values;
}

/// Selects the rows in `kept`.
std::vector<float> rows_of(const std::vector<float>& values, std::size_t width,
                           const std::vector<std::size_t>& kept) {
  std::vector<float> chosen;
  chosen.reserve(kept.size() * width);
  for (const auto row : kept) {
    for (std::size_t c = 0; c < width; ++c) chosen.push_back(values[row * width + c]);
  }
  return chosen;
}

}  // namespace

struct RunReader::File {
  Handle file, run;
  FrameStore frames;
  SurfaceStore surfaces;

  explicit File(const std::filesystem::path& path)
      : file(open_file(path)), run(hdf5::open_group(file, "run")), frames(file), surfaces(file) {
    if (surfaces.holds_any() && surfaces.spans().size() < frames.frames().size())
      throw std::out_of_range("surfaces");
  }
};

template <class Read>
auto RunReader::guarded(Read read) const {
  try {
    return read();
  } catch (const hdf5::Failure& failure) {
    throw OutputError(path_, fmt::format("cannot {}: {}", failure.doing, failure.reason), remedy);
  } catch (const std::logic_error&) {  // inconsistent counts
    throw OutputError(path_, "its frames contradict each other", remedy);
  }
}

RunReader::RunReader(const std::filesystem::path& folder) : path_(folder / "result.h5") {
  std::error_code error;
  if (!std::filesystem::exists(path_, error))
    throw InputError(fmt::format(
        "{}: {}; give the folder that `pliant run` or `pliant batch` wrote to", folder.string(),
        std::filesystem::exists(folder, error) ? "holds no result.h5" : "does not exist"));
  hdf5::silence();
  file_ = guarded([&] { return std::make_unique<File>(path_); });
}

RunReader::~RunReader() = default;

std::string RunReader::text(const std::string& attribute) const {
  return guarded([&] { return hdf5::read_text_attribute(file_->run, attribute); });
}

int RunReader::dimension() const {
  return guarded([&] { return hdf5::read_attribute(file_->run, "dimension"); });
}

std::string RunReader::settings() const {
  return guarded([&] { return hdf5::read_text(file_->run, "case.toml"); });
}

const std::vector<FrameSpan>& RunReader::frames() const { return file_->frames.frames(); }

const std::vector<StoredField>& RunReader::fields() const { return file_->frames.fields(); }

std::string RunReader::unit_of(const std::string& field) const {
  return guarded([&] {
    const auto group = hdf5::open_group(file_->file, "VTKHDF/PointData");
    return hdf5::read_text_attribute(GrowingArray::open(group, field).id(), "unit");
  });
}

FramePoints RunReader::particles(std::size_t frame, const std::vector<Scalar>& scalars) const {
  return guarded([&] {
    const auto& span = frames().at(frame);
    const auto root = hdf5::open_group(file_->file, "VTKHDF");
    const auto group = hdf5::open_group(root, "PointData");
    std::vector<std::size_t> kept;
    std::vector<std::int32_t> kinds(span.particles, particle);
    if (hdf5::exists(group, "kind"))
      GrowingArray::open(group, "kind").read(kinds.data(), span.first, span.particles);
    kept.reserve(kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (kinds[i] == particle) kept.push_back(i);
    }
    FramePoints points;
    std::vector<float> position(3 * span.particles);
    GrowingArray::open(root, "Points").read(position.data(), span.first, span.particles);
    points.position = rows_of(position, 3, kept);
    points.values.reserve(scalars.size());
    for (const auto& scalar : scalars)
      points.values.push_back(
          rows_of(read_scalar(group, scalar, span.first, span.particles), 1, kept));
    return points;
  });
}

int RunReader::corners() const {
  return file_->surfaces.holds_any() ? file_->surfaces.corners() : 0;
}

FramePoints RunReader::surface(std::size_t frame, const std::vector<Scalar>& scalars,
                               const FramePoints& particles) const {
  return guarded([&] {
    const auto& span = file_->surfaces.spans().at(frame);
    const auto root = hdf5::open_group(file_->file, "surface");
    const auto group = hdf5::open_group(root, "PointData");
    FramePoints points;
    points.position.resize(3 * span.vertices);
    GrowingArray::open(root, "Points")
        .read(points.position.data(), span.first_vertex, span.vertices);
    std::vector<std::int64_t> vertex(span.pieces * static_cast<std::size_t>(corners()));
    GrowingArray::open(root, "Connectivity").read(vertex.data(), span.first_piece, span.pieces);
    points.vertex.reserve(vertex.size());
    for (const auto v : vertex) {
      if (v < 0 || static_cast<std::uint64_t>(v) >= span.vertices)
        throw std::out_of_range("vertex");
      points.vertex.push_back(static_cast<std::uint32_t>(v));
    }
    std::vector<std::size_t> missing;
    points.values.resize(scalars.size());
    for (std::size_t s = 0; s < scalars.size(); ++s) {
      if (hdf5::exists(group, scalars[s].field))
        points.values[s] = read_scalar(group, scalars[s], span.first_vertex, span.vertices);
      else
        missing.push_back(s);
    }
    take_nearest_values(particles, missing, points);
    return points;
  });
}

std::vector<History> RunReader::histories() const {
  return guarded([&] {
    std::vector<History> histories;
    if (!hdf5::exists(file_->file, "measurements")) return histories;
    const auto group = hdf5::open_group(file_->file, "measurements");
    for (const auto& name : hdf5::names(group)) {
      const auto one = hdf5::open_group(group, name);
      History history{
          .name = name,
          .unit = hdf5::read_text_attribute(GrowingArray::open(one, "value").id(), "unit"),
          .time = hdf5::read_column(one, "time"),
          .value = hdf5::read_column(one, "value")};
      // After a kill, one column may be longer than the other.
      const auto rows = std::min(history.time.size(), history.value.size());
      history.time.resize(rows);
      history.value.resize(rows);
      histories.push_back(std::move(history));
    }
    return histories;
  });
}

}  // namespace pliant::report
