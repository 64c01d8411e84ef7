#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "engine/finite_elements/fields.hpp"
#include "engine/point_based/fields.hpp"
#include "engine/remeshed/state/fields.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/total_lagrangian/fields.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/output/temporary_folder.hpp"

// docs/fields.md, frames and checkpoints show exactly the lists of fields.
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
    case Rank::prony_tensor:
      return "tensors of Prony terms";
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

/// Text for a cell of a table, with `|` escaped.
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
    text_of += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", f.name,
                           cell(f.symbol), cell(f.unit), text(f.rank), spaces[f.space].name,
                           text(f.remeshed), f.copies, f.is_saved ? "yes" : "",
                           f.is_shown ? "yes" : "", f.shares_storage);
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

TEST(fields, of_finite_elements_are_on_their_page) {
  const std::string expected = tables(finite_elements::index_spaces, finite_elements::field_list);
  EXPECT_NE(page().find(expected), std::string::npos) << "docs/fields.md should hold\n" << expected;
}

TEST(fields, of_the_point_based_method_are_on_their_page) {
  const std::string expected = tables(point_based::index_spaces, point_based::field_list);
  EXPECT_NE(page().find(expected), std::string::npos) << "docs/fields.md should hold\n" << expected;
}

using Names = std::set<std::string>;

/// A block of rubber after one step of a method.
std::unique_ptr<Solver> stepped(const std::string& method, const std::string& of_method,
                                const std::string& rest) {
  const Case settings = tests::read_text("method = \"" + method + R"toml("
discretisation = { spacing = 0.125 }
time = { end = 1 }
)toml" + of_method + R"toml(
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
velocity = ["y", "0"]
[body.material]
model = "reduced_polynomial"
coefficients = [10]
compressibility = 0.05
density = 1
)toml" + rest);
  auto solver = methods().make(settings, {});
  solver->step(HUGE_VAL);
  return solver;
}

constexpr auto relaxing = "prony = { ratios = [0.5], times = [0.1] }\n";

std::unique_ptr<Solver> stepped_remeshed() { return stepped("remeshed", "", relaxing); }
const std::string in_shear = "prony_shear = { ratios = [0.5], times = [0.1] }\n";
std::unique_ptr<Solver> stepped_total_lagrangian() {
  return stepped("total_lagrangian", "total_lagrangian = { damping = \"adaptive\" }",
                 relaxing + in_shear);
}
// A case that uses every field.
std::unique_ptr<Solver> stepped_point_based() {
  return stepped("point_based",
                 "point_based = { damping = \"adaptive\", stiffness_damping = 1e-4 }",
                 relaxing + in_shear + R"toml([[cut]]
name = "slit"
from = [0.5, 1.1]
path = [0, "-t"]
end = 0.5
)toml");
}

/// Names of fields with their units.
template <class Fields>
Names shown(const Fields& fields) {
  Names names;
  for (const auto& f : fields) {
    if (f.is_shown) names.insert(fmt::format("{} [{}]", f.name, f.unit));
  }
  return names;
}

/// Fields of a frame that are not derived from others.
Names fields_of_frame(Solver& solver, const Names& derived) {
  Names names;
  for (const FrameField& f : solver.frame({}).fields) {
    if (!derived.contains(f.name)) names.insert(fmt::format("{} [{}]", f.name, f.unit));
  }
  return names;
}

TEST(frames, show_exactly_the_shown_fields) {
  EXPECT_EQ(fields_of_frame(*stepped_remeshed(), {"pressure", "density", "body"}),
            shown(remeshed::field_list));
  const Names derived = {"pressure", "density", "stress", "dilatation", "kind", "body"};
  EXPECT_EQ(fields_of_frame(*stepped_total_lagrangian(), derived),
            shown(total_lagrangian::field_list));
  EXPECT_EQ(fields_of_frame(*stepped_point_based(), derived), shown(point_based::field_list));
}

template <class Fields>
Names saved(const Fields& fields) {
  Names names;
  for (const auto& f : fields) {
    if (f.is_saved) names.insert(std::string(f.name));
  }
  return names;
}

/// Names of the fields of these groups in a checkpoint, without `others`, which are no fields.
Names fields_of_checkpoint(const Solver& solver, const std::vector<std::string>& groups,
                           const Names& others) {
  const TemporaryFolder folder;
  ArchiveWriter writer(folder / "state.h5");
  solver.save(writer);
  writer.commit();
  const ArchiveReader reader(folder / "state.h5");
  Names names;
  for (const std::string& group : groups) {
    for (const std::string& name : reader.names(group)) {
      if (!others.contains(name)) names.insert(name);
    }
  }
  return names;
}

TEST(checkpoints, hold_exactly_the_saved_fields) {
  Names of_bodies = saved(remeshed::field_list);
  // One array for all bodies.
  ASSERT_EQ(of_bodies.erase("momentum_budget"), 1u);
  ASSERT_EQ(of_bodies.erase("motion_budget"), 1u);
  EXPECT_EQ(fields_of_checkpoint(*stepped_remeshed(), {"body/0", "body/0/ghosts"},
                                 {"occupied_cells", "lattice_origin", "particles", "strain",
                                  "strain_rate", "ghosts", "reached"}),
            of_bodies);
  EXPECT_EQ(fields_of_checkpoint(*stepped_total_lagrangian(), {"body/0"}, {}),
            saved(total_lagrangian::field_list));
  EXPECT_EQ(fields_of_checkpoint(*stepped_point_based(), {"body/0"}, {"cuts"}),
            saved(point_based::field_list));
}

}  // namespace
}  // namespace pliant::test
