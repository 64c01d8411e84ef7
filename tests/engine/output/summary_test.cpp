#include "engine/output/summary.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

Summary sample() {
  Summary summary;
  summary.case_name = "rotating \"cylinder\"";
  summary.versions = {{"pliant", "0.1.0"}, {"hdf5", "1.10.8"}};
  summary.method = "remeshed";
  summary.particles = {.start = 800, .end = 812, .ghosts = 96};
  summary.steps = 1234;
  summary.physical_time = 0.1 + 0.2;
  summary.wall_time = 1.0 / 3;
  summary.phases = {{"stress", 0.7}, {"advance", 0.2}};
  summary.performance = {.particle_stages_per_second = 1.8e7,
                         .particle_stages = std::int64_t{1} << 53,
                         .step_wall_time = 3.5,
                         .threads = 2,
                         .isa = "avx512"};
  summary.conserved.start.momentum = {1, 5e-324, -0.0};
  summary.conserved.end.total_energy = std::numeric_limits<double>::max();
  summary.measurements = {{"radius", "m", 0.1}, {"broken", "1", std::nan(""), "it broke"}};
  return summary;
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(summary, is_json_whose_numbers_read_back_to_the_same_bits) {
  const TemporaryFolder folder;
  const auto summary = sample();
  write_summary(folder.path(), summary);
  const auto json = nlohmann::json::parse(text_of(folder / "summary.json"));
  EXPECT_EQ(json["case"], summary.case_name);
  EXPECT_EQ(json["particles"]["end"], 812);
  EXPECT_EQ(bits(json["physical_time"]), bits(summary.physical_time));
  EXPECT_EQ(bits(json["wall_time"]), bits(summary.wall_time));
  EXPECT_EQ(bits(json["conserved"]["start"]["momentum"][1]), bits(5e-324));
  EXPECT_EQ(bits(json["conserved"]["start"]["momentum"][2]), bits(-0.0));
  EXPECT_EQ(bits(json["conserved"]["end"]["total_energy"]),
            bits(std::numeric_limits<double>::max()));
  EXPECT_EQ(json["performance"]["particle_stages"], std::int64_t{1} << 53);
  EXPECT_EQ(json["performance"]["particle_stages_per_second"], 1.8e7);
  EXPECT_EQ(json["performance"]["threads"], 2);
  EXPECT_EQ(json["phases"]["stress"], 0.7);
  EXPECT_EQ(json["measurements"]["radius"]["value"], 0.1);
  EXPECT_EQ(json["measurements"]["radius"]["unit"], "m");
  EXPECT_FALSE(json["measurements"]["radius"].contains("reason"));
  EXPECT_TRUE(json["measurements"]["broken"]["value"].is_null());
  EXPECT_EQ(json["measurements"]["broken"]["reason"], "it broke");
}

TEST(summary, keys_keep_their_order) {
  const auto json = nlohmann::ordered_json::parse(json_of(sample()));
  std::vector<std::string> keys;
  for (const auto& entry : json.items()) keys.push_back(entry.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"case", "versions", "method", "precision", "particles",
                                            "steps", "physical_time", "wall_time", "processor_time",
                                            "peak_memory", "phases", "performance", "conserved",
                                            "checks", "measurements"}));
  EXPECT_EQ(json["phases"].begin().key(), "stress");  // in the order of the step, not alphabetical
}

TEST(summary, without_measurements_has_an_empty_object) {
  EXPECT_TRUE(nlohmann::json::parse(json_of(Summary{}))["measurements"].is_object());
}

TEST(summary, a_report_names_folder_and_file_and_aligns_the_measurements) {
  EXPECT_EQ(report_of("results/disc", sample()),
            "results in results/disc; `pliant report results/disc` shows them in a browser, "
            "result.xdmf in ParaView\n"
            "  radius  0.1 m\n"
            "  broken  no value: it broke\n"
            "checks: mass changed by at most 0 %\n");
}

TEST(summary, energy_without_work_is_told_where_the_method_accounts_for_work) {
  Summary summary = sample();
  EXPECT_TRUE(nlohmann::json::parse(json_of(summary))["checks"]["energy"].is_null());
  summary.checks.energy_is_known = true;
  summary.checks.wall_work = 4;
  summary.checks.created = -0.5;
  summary.checks.largest_energy = 5;
  summary.checks.energy = {0.02, 0.3};
  summary.checks.mass = {0.001, 0.4};
  const auto energy = nlohmann::json::parse(json_of(summary))["checks"]["energy"];
  EXPECT_EQ(energy["work_of_walls"], 4);
  EXPECT_EQ(energy["largest_share"], 0.02);
  EXPECT_NE(report_of("out", summary)
                .find("checks: energy changed by -10 % without work (gained at most 2 %), mass by "
                      "at most 0.1 %"),
            std::string::npos);
}

TEST(summary, a_name_that_is_not_utf8_is_written_all_the_same) {
  Summary summary;
  summary.case_name = "\xff";
  EXPECT_EQ(nlohmann::json::parse(json_of(summary))["case"], "\uFFFD");
}

}  // namespace
}  // namespace pliant::test
