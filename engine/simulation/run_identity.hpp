#pragma once

#include <string>

#include "engine/case/case.hpp"
#include "engine/output/archive/archive.hpp"

/// The identity of a run: a run may continue another one if their cases agree in everything except
/// `time.end`, and their mesh files have the same content.
namespace pliant {

/// One hash, 16 hexadecimal digits, of all that must agree. Reads the mesh files; throws InputError
/// when one cannot be read.
std::string identity_of(const Case& settings);

/// Writes the case and the hashes of its mesh files into a checkpoint.
void put_identity(ArchiveWriter& archive, const Case& settings);

/// Throws InputError unless a run of `settings` may continue the run of this checkpoint. The
/// message names the first setting or mesh file that differs. `time.end` must not be earlier than
/// before.
void require_same_run(const ArchiveReader& archive, const Case& settings);

}  // namespace pliant
