#include "engine/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "engine/output/error.hpp"

namespace pliant {
namespace {

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) throw OutputError::system(path, "open it", errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(number_); }

  int number() const { return number_; }

 private:
  int number_;
};

void write_all(const std::filesystem::path& path, std::string_view text) {
  const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  while (!text.empty()) {
    const auto written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw OutputError::system(path, "write it", errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

std::filesystem::path temporary_name(const std::filesystem::path& path) {
  auto name = path;
  name += ".partial";
  return name;
}

void publish(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  if (::fsync(Descriptor(temporary, O_RDONLY).number()) != 0)
    throw OutputError::system(path, "write it to the disk", errno);
  if (::rename(temporary.c_str(), path.c_str()) != 0)
    throw OutputError::system(path, "put it in place", errno);
  // The new name itself lives in the folder. Some file systems cannot sync a folder; the file is
  // in place all the same.
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  ::fsync(Descriptor(folder, O_RDONLY | O_DIRECTORY).number());
}

void write_atomically(const std::filesystem::path& path, std::string_view text) {
  const auto temporary = temporary_name(path);
  try {
    write_all(temporary, text);
    publish(temporary, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

}  // namespace pliant
