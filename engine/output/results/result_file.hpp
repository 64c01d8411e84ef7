#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "engine/output/results/frame.hpp"
#include "engine/output/run_folder.hpp"

namespace pliant {

/// What a result file says about its run: nothing that differs between two equal runs.
struct RunDescription {
  std::string case_name;
  std::string title;
  std::string method;   ///< "remeshed" or "point_based"
  std::string version;  ///< of the program
  int dimension = 2;
  std::string resolved_case;  ///< text of the case with every default
  /// Equal for two runs when one may continue the other.
  std::string identity;
};

/// How far a result file has come: a checkpoint holds it, so that a resumed run continues exactly
/// there.
struct ResultExtent {
  std::int64_t frames = 0;
  std::map<std::string, std::int64_t> history_rows;  ///< by name of the measurement
};

/// `result.h5` in a folder; beside it `result.xdmf`, which shows its frames, `surface.xdmf`, which
/// shows their surfaces, and `case.resolved.toml`, the case with every default.
///
/// Frames lie under /VTKHDF (see frame_store.cpp), surfaces under /surface, histories under
/// /measurements/NAME. A process that is killed leaves a readable file with all completed frames:
/// the file gets its name once the first frame is whole, and arrays only ever grow. Readers may
/// open it while it is written. The file has no time stamps: equal runs write equal files. The
/// folder is locked against a second run.
///
/// All functions throw OutputError when the disk refuses; the file on disk then holds the frames
/// that it held before, and this object accepts no more.
class ResultFile {
 public:
  /// Starts a new file, after `clear_earlier_run`; the result file of an earlier run is replaced
  /// when the first frame is whole.
  static ResultFile create(const std::filesystem::path& folder, const RunDescription& run);

  /// Continues the file of an earlier run, cut back to `extent`, and removes its summary. Throws
  /// InputError when the file's identity is not that of `run`, and OutputError when it holds less
  /// than `extent`; nothing is changed then.
  static ResultFile resume(const std::filesystem::path& folder, const RunDescription& run,
                           const ResultExtent& extent);

  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;
  ~ResultFile();  ///< closes and ignores errors

  /// Writes a frame and the histories so far. Throws std::invalid_argument when the frame's fields
  /// differ from those of the earlier frames.
  void append(const Frame& frame);

  /// Adds a row to /measurements/NAME; it is written with the next frame, flush or close.
  void append_history(const std::string& name, const std::string& unit, double time, double value);

  /// Brings everything to the disk and returns how far that is, for a checkpoint to hold.
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
