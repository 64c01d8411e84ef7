#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "engine/simulation/methods.hpp"

namespace pliant {
namespace {

TEST(faulty_paths, a_missing_file_is_named) {
  try {
    read_case("no_such_case.toml");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_STREQ(error.what(),
                 "no_such_case.toml: cannot be read; give the path of a case file, or of a folder "
                 "with a case.toml");
  }
}

TEST(faulty_paths, a_folder_without_a_case_is_named) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("pliant_empty_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  EXPECT_THROW(read_case(folder), CaseError);
  std::filesystem::remove(folder);
}

}  // namespace
}  // namespace pliant
