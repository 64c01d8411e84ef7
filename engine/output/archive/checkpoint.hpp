#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/output/archive/archive.hpp"
#include "engine/output/results/result_file.hpp"

/// The last two checkpoints of a run are in its folder: `checkpoint.h5`, and the one before,
/// `checkpoint.previous.h5`. If the process is killed at any time, at least one of them is intact.
/// All functions throw OutputError.
namespace pliant {

/// Writes a checkpoint with the content that `fill` puts; the last one becomes the previous one.
void write_checkpoint(const std::filesystem::path& folder,
                      const std::function<void(ArchiveWriter&)>& fill);

/// The latest intact checkpoint of a folder: if the last one is damaged, the previous one, as
/// `path()` of the reader shows. Throws InputError when the folder has no checkpoint.
ArchiveReader open_checkpoint(const std::filesystem::path& folder);

/// Every checkpoint contains the extent of the result file.
void put_extent(ArchiveWriter& archive, const std::string& group, const ResultExtent& extent);
ResultExtent get_extent(const ArchiveReader& archive, const std::string& group);

}  // namespace pliant
