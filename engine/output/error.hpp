#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace pliant {

/// A file could not be written or read. The message says which, why, and what to do about it.
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::filesystem::path& path, std::string_view what, std::string_view remedy);

  /// From the error number of a failed system call: "PATH: cannot DO: REASON; REMEDY".
  static OutputError system(const std::filesystem::path& path, std::string_view doing,
                            int error_number);
};

/// What a user can do about a failed system call on a file.
std::string_view remedy_for(int error_number);

}  // namespace pliant
