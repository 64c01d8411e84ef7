#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pliant::report {

struct ReportOptions {
  std::vector<std::string> fields;  ///< empty: the most important ones
  /// CSV with time in its first column; none: cases/<case>/reference.csv, if it exists.
  std::optional<std::filesystem::path> reference;
  std::size_t limit = 29'000'000;  ///< largest size of the page [B]
};

/// Writes the page of a run. Throws InputError and OutputError.
void write_run_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                      const ReportOptions& options);

}  // namespace pliant::report
