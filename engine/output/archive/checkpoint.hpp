#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/output/archive/archive.hpp"
#include "engine/output/results/result_file.hpp"

/// The last two checkpoints of a run lie in its folder: `checkpoint.h5`, and before it
/// `checkpoint.previous.h5`. A kill at any instant leaves at least one that is whole. All functions
/// throw OutputError.
namespace pliant {

/// Writes a checkpoint, whose content `fill` puts; the last one becomes the previous one.
void write_checkpoint(const std::filesystem::path& folder,
                      const std::function<void(ArchiveWriter&)>& fill);

/// The latest checkpoint of a folder that is whole: the previous one when the last is damaged, as
/// `path()` of the reader shows. Throws InputError when the folder has no checkpoint.
ArchiveReader open_checkpoint(const std::filesystem::path& folder);

/// Every checkpoint holds how far the result file had come.
void put_extent(ArchiveWriter& archive, const std::string& group, const ResultExtent& extent);
ResultExtent get_extent(const ArchiveReader& archive, const std::string& group);

}  // namespace pliant
