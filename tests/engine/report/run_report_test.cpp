#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <cmath>
#include <fstream>
#include <random>
#include <regex>

#include "engine/output/error.hpp"
#include "engine/output/results/result_file.hpp"
#include "engine/report/page.hpp"
#include "engine/report/report.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/report/page_content.hpp"

namespace pliant::test {
namespace {

constexpr int ghost = 0, particle = 1;

/// Particles in a box that moves and stretches; one in ten is a ghost.
Frame frame_of(int number, int count, bool has_surface) {
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> any(0, 1);
  Frame frame;
  frame.time = 0.5 * number;
  std::vector<double> pressure;
  std::vector<std::int32_t> kind;
  for (int p = 0; p < count; ++p) {
    const double x = any(chance), y = any(chance), z = any(chance);
    frame.position.insert(frame.position.end(), {x + 0.1 * number, 2 * y, z * (1 + number)});
    pressure.push_back(100 * (x - 0.5) * number);
    kind.push_back(p % 10 == 0 ? ghost : particle);
  }
  frame.fields = {{"pressure", "Pa", 1, pressure}, {"kind", "1", 1, kind}};
  if (!has_surface) return frame;
  frame.surface.emplace();
  frame.surface->position = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 1};
  frame.surface->vertex = {0, 1, 2, 0, 2, 3};
  return frame;
}

void write_run(const std::filesystem::path& folder, int frames, int count, bool has_surface,
               const std::string& title = "A box") {
  const RunDescription run = {
      .case_name = "box",
      .title = title,
      .method = "remeshed",
      .version = "0.1.0",
      .dimension = 3,
      .resolved_case = "gravity = [0, -9.81, 0]\n[discretisation]\nspacing = 0.125\n",
      .identity = "0123456789abcdef"};
  auto file = ResultFile::create(folder, run);
  for (int f = 0; f < frames; ++f) {
    file.append_history("height", "m", 0.5 * f, 1 + f);
    file.append(frame_of(f, count, has_surface));
  }
  file.close();
}

PageContent page_of_run(const TemporaryFolder& folder, const report::ReportOptions& options = {}) {
  report::write_run_report(folder.path(), folder / "report.html", options);
  return content_of_page(folder / "report.html");
}

std::string refusal_of(const TemporaryFolder& folder) {
  try {
    report::write_run_report(folder.path(), folder / "report.html", {});
  } catch (const OutputError& error) {
    return error.what();
  }
  return "no error";
}

// Positions are rounded to 1/65535 of the longest side, numbers to 1/65535 of their range.
TEST(run_report, positions_and_fields_are_read_back_without_ghosts) {
  const TemporaryFolder folder;
  write_run(folder.path(), 3, 200, false);
  const auto page = page_of_run(folder);
  ASSERT_EQ(page.frames.size(), 3u);
  const double size = page.run["box"]["size"], lo = page.run["fields"][0]["lo"],
               hi = page.run["fields"][0]["hi"];
  std::vector<std::vector<std::uint32_t>> numbers(4);
  for (int f = 0; f < 3; ++f) {
    ASSERT_EQ(page.run["sets"][0]["points"][f], 180);
    NumberReader reader(page.frames[f]);
    for (auto& array : numbers) array = reader.next(180, 2, array);
    EXPECT_TRUE(reader.at_end());
    const Frame frame = frame_of(f, 200, false);
    const auto& pressure = std::get<std::vector<double>>(frame.fields[0].values);
    for (std::size_t p = 0, i = 0; p < 200; ++p) {
      if (p % 10 == 0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double origin = page.run["box"]["origin"][axis];
        EXPECT_NEAR(origin + numbers[axis][i] / 65535.0 * size, frame.position[3 * p + axis],
                    0.51 / 65535 * size + 1e-6);
      }
      EXPECT_NEAR(lo + numbers[3][i] / 65535.0 * (hi - lo), pressure[p],
                  0.51 / 65535 * (hi - lo) + 1e-4);
      ++i;
    }
  }
}

TEST(run_report, surfaces_take_fields_from_the_particles_nearby) {
  const TemporaryFolder folder;
  write_run(folder.path(), 2, 4000, true);
  const auto page = page_of_run(folder);
  const auto& set = page.run["sets"][0];
  EXPECT_EQ(set["kind"], "surface");
  EXPECT_EQ(set["pieces"], (nlohmann::json{2, 2}));
  EXPECT_EQ(set["same"], (nlohmann::json{false, true})) << "equal triangles are held once";
  NumberReader first(page.frames[0]), second(page.frames[1]);
  std::vector<std::vector<std::uint32_t>> numbers(4);
  for (auto& array : numbers) array = first.next(4, 2);
  EXPECT_EQ(first.next(6, 4), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  for (auto& array : numbers) array = second.next(4, 2, array);
  const double lo = page.run["fields"][0]["lo"], hi = page.run["fields"][0]["hi"];
  // 100 (x - 0.5) with x = X - 0.1 at the corners X = 0 and 1 of the box; particles are about 0.07
  // apart, so that the nearest pressures differ from it by less than 12.
  EXPECT_NEAR(lo + numbers[3][0] / 65535.0 * (hi - lo), -50, 12);
  EXPECT_NEAR(lo + numbers[3][1] / 65535.0 * (hi - lo), 40, 12);
}

TEST(run_report, histories_summary_and_layout_are_in_the_page) {
  const TemporaryFolder folder;
  write_run(folder.path(), 3, 50, false);
  std::ofstream(folder / "summary.json") << R"({"steps": 12})";
  std::ofstream(folder / "curves.csv") << "t,height,width\n0,1,9\n1,3,9\n";
  report::ReportOptions options;
  options.reference = folder / "curves.csv";
  const auto page = page_of_run(folder, options);
  EXPECT_EQ(page.run["histories"][0]["value"], (nlohmann::json{1, 2, 3}));
  EXPECT_EQ(page.run["histories"][0]["unit"], "m");
  ASSERT_EQ(page.run["histories"][0]["references"].size(), 1u);
  EXPECT_EQ(page.run["histories"][0]["references"][0]["value"], (nlohmann::json{1, 3}));
  EXPECT_EQ(page.run["summary"]["steps"], 12);
  EXPECT_EQ(page.run["up"], "y");
  EXPECT_EQ(page.run["spacing"], 0.125);
}

// The policy of the page makes browsers refuse other addresses; here no address is requested.
TEST(run_report, a_page_refers_to_no_other_file) {
  const std::string page(report::empty_page());
  const std::regex elsewhere(
      R"re((src|href|action)\s*=\s*["']?(https?:|//)|url\(\s*["']?(https?:|//)|@import|import\(["'`])re");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(page, found, elsewhere)) << found.str();
  EXPECT_NE(page.find("default-src 'none'"), page.npos);
}

TEST(run_report, no_text_of_a_case_can_end_a_script) {
  const TemporaryFolder folder;
  write_run(folder.path(), 1, 20, false, "</script><script>alert(1)</script>");
  const auto page = page_of_run(folder);
  EXPECT_EQ(page.run["title"], "</script><script>alert(1)</script>");
  EXPECT_EQ(page.text.find("<script>alert"), page.text.npos);
}

TEST(run_report, a_large_run_is_thinned_to_the_limit_and_the_page_says_so) {
  const TemporaryFolder folder;
  write_run(folder.path(), 60, 2000, false);
  const auto whole = page_of_run(folder);
  EXPECT_TRUE(whole.run["notes"].dump().find("This page shows") == std::string::npos);
  report::ReportOptions options;
  options.limit = report::empty_page().size() + 300'000;
  const auto page = page_of_run(folder, options);
  EXPECT_GT(whole.text.size(), options.limit);
  EXPECT_LE(page.text.size(), options.limit);
  EXPECT_EQ(page.run["notes"][1], "This page shows 31 of 60 frames.");
  EXPECT_EQ(page.run["times"].back(), 29.5) << "the last frame is always there";
}

TEST(run_report, a_folder_without_a_result_is_refused_with_a_remedy) {
  const TemporaryFolder folder;
  EXPECT_THROW(report::write_run_report(folder.path(), folder / "report.html", {}), InputError);
}

TEST(run_report, a_damaged_result_is_an_error_that_names_the_file) {
  const TemporaryFolder folder;
  write_run(folder.path(), 3, 5000, true);
  const auto file = folder / "result.h5";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const auto refusal = refusal_of(folder);
  EXPECT_NE(refusal.find(file.string() + ": cannot "), refusal.npos) << refusal;
  EXPECT_NE(refusal.find("run the case again"), refusal.npos) << refusal;
  std::ofstream(file) << "no HDF5";
  EXPECT_NE(refusal_of(folder).find(file.string() + ": cannot open"), refusal.npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));
}

}  // namespace
}  // namespace pliant::test
