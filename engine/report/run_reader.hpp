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

struct History {
  std::string name, unit;
  std::vector<double> time, value;
};

/// Reads the result file of a run. All functions throw OutputError for a damaged file.
class RunReader {
 public:
  /// Throws InputError if the folder has no result file.
  explicit RunReader(const std::filesystem::path& folder);
  ~RunReader();

  std::string text(const std::string& attribute) const;  ///< "case", "title", "method"
  int dimension() const;
  std::string settings() const;  ///< the case with all defaults

  const std::vector<FrameSpan>& frames() const;
  const std::vector<StoredField>& fields() const;
  std::string unit_of(const std::string& field) const;

  /// The particles of a frame, without ghosts.
  FramePoints particles(std::size_t frame, const std::vector<Scalar>& scalars) const;

  /// Corners of a piece of the surface: 3 for triangles, 2 for segments, 0 without a surface.
  int corners() const;
  /// The surface of a frame; scalars that it does not have itself come from the nearest
  /// `particles`.
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
