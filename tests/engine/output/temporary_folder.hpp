#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pliant::test {

/// A separate empty folder for each test, removed at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
    std::string name = test.name();
    std::replace(name.begin(), name.end(), '/', '.');  // as in names of parametrised tests
    path_ = std::filesystem::temp_directory_path() /
            ("pliant." + std::to_string(::getpid()) + "." + name);
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace pliant::test
