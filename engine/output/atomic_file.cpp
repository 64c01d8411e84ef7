#include "engine/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "engine/output/descriptor.hpp"

namespace pliant {
namespace {

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

TemporaryFile::TemporaryFile(const std::filesystem::path& final_path)
    : final_path_(final_path), path_(final_path) {
  path_ += ".partial";
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  if (!published_) std::filesystem::remove(path_, ignored);
}

void TemporaryFile::publish(Durable durable) {
  if (durable == Durable::yes && ::fsync(Descriptor(path_, O_RDONLY).number()) != 0)
    throw OutputError::system(final_path_, "write it to the disk", errno);
  if (::rename(path_.c_str(), final_path_.c_str()) != 0)
    throw OutputError::system(final_path_, "put it in place", errno);
  published_ = true;
  // The new name is part of the folder. Some file systems cannot sync a folder; the file is in
  // place anyway.
  if (durable == Durable::no) return;
  const auto folder =
      final_path_.has_parent_path() ? final_path_.parent_path() : std::filesystem::path(".");
  ::fsync(Descriptor(folder, O_RDONLY | O_DIRECTORY).number());
}

void write_atomically(const std::filesystem::path& path, std::string_view text, Durable durable) {
  TemporaryFile file(path);
  write_all(file.path(), text);
  file.publish(durable);
}

}  // namespace pliant
