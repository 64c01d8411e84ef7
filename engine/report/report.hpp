#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pliant::report {

struct ReportOptions {
  std::vector<std::string> fields;  ///< empty: those that matter most
  /// CSV with time in its first column; without it, cases/<case>/reference.csv if there is one.
  std::optional<std::filesystem::path> reference;
  std::size_t limit = 29'000'000;  ///< bytes of the page
};

/// Writes a page that shows a run. Throws InputError and OutputError.
void write_run_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                      const ReportOptions& options);

}  // namespace pliant::report
