#pragma once

#include <string>

#include "engine/case/case.hpp"
#include "engine/output/archive/archive.hpp"

/// What makes two runs one: a run may continue another when their cases agree in everything but
/// `time.end`, and their mesh files have the same content.
namespace pliant {

/// One hash of all that must agree, as 16 hexadecimal digits. Reads the mesh files; throws
/// InputError when one cannot be read.
std::string identity_of(const Case& settings);

/// Puts the case and the hashes of its mesh files into a checkpoint.
void put_identity(ArchiveWriter& archive, const Case& settings);

/// Throws InputError unless a run of `settings` may continue the run of this checkpoint. The
/// message names the first setting or mesh file that differs. `time.end` must not be earlier than
/// it was.
void require_same_run(const ArchiveReader& archive, const Case& settings);

}  // namespace pliant
