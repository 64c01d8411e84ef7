#pragma once

#include <filesystem>

namespace pliant::report {

/// Writes the page of a batch: measurements over parameters. Throws OutputError.
void write_batch_report(const std::filesystem::path& folder, const std::filesystem::path& page);

}  // namespace pliant::report
