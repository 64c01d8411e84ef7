#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace pliant::test {

/// An array or an attribute of an HDF5 file, as any reader sees it.
struct Content {
  std::vector<std::uint64_t> shape;
  std::string bytes;

  bool operator==(const Content&) const = default;

  template <class T>
  std::vector<T> as() const {
    if (bytes.size() % sizeof(T) != 0) throw std::runtime_error("other type");
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

/// The whole content of a file by path: datasets as "/group/name", attributes as
/// "/group/name@attribute"; hard links appear under each of their names. Reads with plain HDF5
/// calls and none of the writer's code.
using FileContent = std::map<std::string, Content>;
FileContent content_of(const std::filesystem::path& path);

/// The paths at which two files differ; empty for files that h5diff considers equal.
std::vector<std::string> differences(const FileContent& a, const FileContent& b);

}  // namespace pliant::test
