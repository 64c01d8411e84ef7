#include "engine/output/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace pliant {

OutputError::OutputError(const std::filesystem::path& path, std::string_view what,
                         std::string_view remedy)
    : std::runtime_error(fmt::format("{}: {}; {}", path.string(), what, remedy)) {}

OutputError OutputError::system(const std::filesystem::path& path, std::string_view doing,
                                int error_number) {
  const auto reason = std::generic_category().message(error_number);
  return {path, fmt::format("cannot {}: {}", doing, reason), remedy_for(error_number)};
}

std::string_view remedy_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free some space there, or choose a folder on another disk with --out";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f), or choose a folder on another disk with "
             "--out";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder that you may write to with --out";
    case ENOENT:
    case ENOTDIR:
      return "check the path";
    default:
      return "check the disk, or choose a folder on another one with --out";
  }
}

}  // namespace pliant
