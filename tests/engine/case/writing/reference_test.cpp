#include "engine/case/writing/reference.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/simulation/methods.hpp"

namespace pliant {
namespace {

TEST(reference, the_committed_page_is_what_the_program_writes) {
  const std::filesystem::path page =
      std::filesystem::path(PLIANT_SOURCE_DIR) / "docs" / "case-reference.md";
  std::ifstream stream(page);
  const std::string committed{std::istreambuf_iterator<char>(stream), {}};
  const std::string written = case_reference_markdown(methods().rules());
  if (committed == written) return;
  const std::filesystem::path fresh = std::filesystem::current_path() / "case-reference.md";
  std::ofstream(fresh) << written;
  FAIL() << "The vocabulary changed. Look at the page and commit it:\n  cp " << fresh.string()
         << " " << page.string();
}

}  // namespace
}  // namespace pliant
