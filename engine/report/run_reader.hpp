#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/output/results/frame_store.hpp"
#include "engine/report/frame_points.hpp"
#include "engine/report/scalars.hpp"

namespace pliant::report {

/// The history of a measurement.
struct History {
  std::string name, unit;
  std::vector<double> time, value;
};

/// The result file of a run, to read. All functions throw OutputError for a damaged file.
class RunReader {
 public:
  /// Throws InputError where the folder has no result file.
  explicit RunReader(const std::filesystem::path& folder);
  ~RunReader();

  std::string text(const std::string& attribute) const;  ///< "case", "title", "method"
  int dimension() const;
  std::string settings() const;  ///< the case with every default

  const std::vector<FrameSpan>& frames() const;
  const std::vector<StoredField>& fields() const;
  std::string unit_of(const std::string& field) const;

  /// The particles of a frame, without ghosts.
  FramePoints particles(std::size_t frame, const std::vector<Scalar>& scalars) const;

  /// Corners of a piece of the surface: 3 triangles, 2 segments, 0 where the run has none.
  int corners() const;
  /// The surface of a frame; numbers that it has not itself are those of the `particles` nearby.
  FramePoints surface(std::size_t frame, const std::vector<Scalar>& scalars,
                      const FramePoints& particles) const;

  std::vector<History> histories() const;

 private:
  struct File;
  template <class Read>
  auto guarded(Read read) const;

  std::filesystem::path path_;
  std::unique_ptr<File> file_;
};

}  // namespace pliant::report
