#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "engine/case/reading/read_case.hpp"
#include "engine/method/registry.hpp"

namespace pliant {

/// The methods of the program. Only the list in methods.cpp names them all.
const MethodRegistry& methods();

/// Reads and checks a case file for these methods. Throws CaseError.
Case read_case(const std::filesystem::path& path, std::span<const std::string> settings = {});

}  // namespace pliant
