#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "engine/output/results/frame.hpp"
#include "engine/output/run_folder.hpp"

namespace pliant {

/// What a result file says about its run; equal for equal runs.
struct RunDescription {
  std::string case_name;
  std::string title;
  std::string method;   ///< "remeshed" or "point_based"
  std::string version;  ///< of the program
  int dimension = 2;
  std::string resolved_case;  ///< text of the case with every default
  /// Equal for two runs if one may continue the other.
  std::string identity;
};

/// The extent of a result file. A checkpoint contains it, so that a resumed run continues exactly
/// there.
struct ResultExtent {
  std::int64_t frames = 0;
  std::map<std::string, std::int64_t> history_rows;  ///< by name of the measurement
};

/// `result.h5` in a folder, with `result.xdmf`, which shows its frames, `surface.xdmf`, which shows
/// their surfaces, and `case.resolved.toml`, the case with all defaults.
///
/// Frames are in /VTKHDF (see frame_store.cpp), surfaces in /surface, histories in
/// /measurements/NAME. A killed process leaves a readable file with all completed frames: the file
/// gets its name when the first frame is complete, and arrays only grow. Readers may open it while
/// it is written. It has no time stamps, so equal runs write equal files. The folder is locked
/// against a second run.
///
/// All functions throw OutputError when a write fails. The file on disk then contains the frames
/// that it had before, and this object accepts no more.
class ResultFile {
 public:
  /// Starts a new file, after `clear_earlier_run`. The result file of an earlier run is replaced
  /// when the first frame is complete.
  static ResultFile create(const std::filesystem::path& folder, const RunDescription& run);

  /// Continues the file of an earlier run, cut to `extent`, and removes its summary. Throws
  /// InputError if the identity of the file is not that of `run`, and OutputError if it contains
  /// less than `extent`; nothing changes then.
  static ResultFile resume(const std::filesystem::path& folder, const RunDescription& run,
                           const ResultExtent& extent);

  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;
  ~ResultFile();  ///< closes and ignores errors

  /// Writes a frame and the histories so far. Throws std::invalid_argument if the fields of the
  /// frame differ from those of earlier frames.
  void append(const Frame& frame);

  /// Adds a row to /measurements/NAME; it is written with the next frame, flush or close.
  void append_history(const std::string& name, const std::string& unit, double time, double value);

  /// Writes everything to the disk. Returns the extent of the file, for a checkpoint.
  ResultExtent flush();

  void close();

 private:
  struct File;
  explicit ResultFile(std::unique_ptr<File> file);
  File& open_file() const;
  static FolderLock cut(const std::filesystem::path& folder, const RunDescription& run,
                        const ResultExtent& extent);
  std::unique_ptr<File> file_;
};

}  // namespace pliant
