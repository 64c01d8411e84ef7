#include "engine/output/atomic_file.hpp"

#include <gtest/gtest.h>

#include "engine/output/error.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

TEST(atomic_file, replaces_the_old_file_and_leaves_no_other) {
  const TemporaryFolder folder;
  const auto path = folder / "page.json";
  write_atomically(path, "old", Durable::yes);
  const std::string long_text(1'000'000, 'x');
  write_atomically(path, long_text, Durable::yes);
  EXPECT_EQ(text_of(path), long_text);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(atomic_file, an_old_file_that_is_open_keeps_its_content) {
  const TemporaryFolder folder;
  write_atomically(folder / "page.json", "old", Durable::yes);
  std::ifstream reader(folder / "page.json");
  write_atomically(folder / "page.json", "new", Durable::no);
  std::string text;
  reader >> text;
  EXPECT_EQ(text, "old");
}

TEST(atomic_file, errors_name_the_path_and_the_remedy) {
  const TemporaryFolder folder;
  try {
    write_atomically(folder / "absent/page.json", "text", Durable::yes);
    FAIL() << "the folder does not exist";
  } catch (const OutputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("absent/page.json"), message.npos) << message;
    EXPECT_NE(message.find("No such file or directory; check the path"), message.npos) << message;
  }
}

}  // namespace
}  // namespace pliant::test
