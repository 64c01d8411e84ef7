#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/point_based/fields.hpp"
#include "engine/remeshed/fields.hpp"
#include "engine/total_lagrangian/fields.hpp"

// docs/fields.md shows the lists of fields as they are.
namespace pliant::test {
namespace {

std::string_view text(Rank rank) {
  switch (rank) {
    case Rank::scalar:
      return "1";
    case Rank::vector:
      return "D";
    case Rank::symmetric_tensor:
      return "D (D + 1)/2";
    case Rank::material:
      return "S: D (D + 1)/2, F: D^2";
    case Rank::prony:
      return "Prony terms";
    case Rank::corner_modes:
      return "D 2^D";
    case Rank::fit_terms:
      return "3 D + 4";
    case Rank::record:
      return "a cache line or two";
    case Rank::list:
      break;
  }
  return "list";
}

std::string_view text(Remeshed remeshed) {
  switch (remeshed) {
    case Remeshed::as_density_times_volume:
      return "density times volume";
    case Remeshed::as_mass_mean:
      return "mean by mass";
    case Remeshed::as_volume_mean:
      return "mean by volume";
    case Remeshed::as_mean:
      return "mean";
    case Remeshed::not_at_all:
      break;
  }
  return "";
}

/// Text for a cell of a table, which `|` would end.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

template <class Spaces, class Fields>
std::string tables(const Spaces& spaces, const Fields& fields) {
  std::string text_of = "| index space | an item is |\n| --- | --- |\n";
  for (const auto& space : spaces) {
    text_of += fmt::format("| {} | {} |\n", space.name, space.meaning);
  }
  text_of +=
      "\n| field | symbol | unit | components | index space | remeshing | copies | saved | shown | "
      "shares storage with |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& f : fields) {
    text_of +=
        fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", f.name,
                    cell(f.symbol), cell(f.unit), text(f.rank),
                    spaces[static_cast<std::size_t>(f.space)].name, text(f.remeshed), f.copies,
                    f.is_saved ? "yes" : "", f.is_shown ? "yes" : "", f.shares_storage);
  }
  return text_of;
}

std::string page() {
  std::ifstream file(PLIANT_SOURCE_DIR "/docs/fields.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(fields, of_the_remeshed_method_are_on_their_page) {
  const std::string expected = tables(remeshed::index_spaces, remeshed::field_list);
  EXPECT_NE(page().find(expected), std::string::npos) << "docs/fields.md should hold\n" << expected;
}

TEST(fields, of_the_total_lagrangian_method_are_on_their_page) {
  const std::string expected = tables(total_lagrangian::index_spaces, total_lagrangian::field_list);
  EXPECT_NE(page().find(expected), std::string::npos) << "docs/fields.md should hold\n" << expected;
}

TEST(fields, of_the_point_based_method_are_on_their_page) {
  const std::string expected = tables(point_based::index_spaces, point_based::field_list);
  EXPECT_NE(page().find(expected), std::string::npos) << "docs/fields.md should hold\n" << expected;
}

}  // namespace
}  // namespace pliant::test
