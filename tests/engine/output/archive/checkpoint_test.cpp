#include "engine/output/archive/checkpoint.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <fstream>

#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

void write_step(const TemporaryFolder& folder, std::int64_t step) {
  write_checkpoint(folder.path(), [&](ArchiveWriter& archive) { archive.put("step", step); });
}

std::int64_t step_of(const ArchiveReader& archive) { return archive.scalar<std::int64_t>("step"); }

TEST(checkpoint, the_last_two_are_kept) {
  const TemporaryFolder folder;
  for (const std::int64_t step : {1, 2, 3}) write_step(folder, step);
  EXPECT_EQ(step_of(open_checkpoint(folder.path())), 3);
  EXPECT_EQ(step_of(ArchiveReader(folder / "checkpoint.previous.h5")), 2);
}

TEST(checkpoint, the_previous_one_serves_when_the_last_is_damaged_or_gone) {
  const TemporaryFolder folder;
  write_step(folder, 1);
  write_step(folder, 2);
  std::filesystem::resize_file(folder / "checkpoint.h5", 900);
  const auto archive = open_checkpoint(folder.path());
  EXPECT_EQ(step_of(archive), 1);
  EXPECT_EQ(archive.path().filename(), "checkpoint.previous.h5");
  std::filesystem::remove(folder / "checkpoint.h5");
  EXPECT_EQ(step_of(open_checkpoint(folder.path())), 1);
}

TEST(checkpoint, a_damaged_last_one_does_not_displace_the_previous) {
  const TemporaryFolder folder;
  write_step(folder, 1);
  write_step(folder, 2);
  // Damage is detected on opening; a run that resumes from the previous checkpoint writes the next
  // one.
  std::filesystem::resize_file(folder / "checkpoint.h5", 900);
  const auto resumed = step_of(open_checkpoint(folder.path()));
  write_step(folder, resumed + 10);
  EXPECT_EQ(step_of(open_checkpoint(folder.path())), 11);
}

TEST(checkpoint, a_failure_while_filling_keeps_both) {
  const TemporaryFolder folder;
  write_step(folder, 1);
  write_step(folder, 2);
  EXPECT_THROW(
      write_checkpoint(folder.path(), [](ArchiveWriter&) { throw std::runtime_error("no state"); }),
      std::runtime_error);
  EXPECT_EQ(step_of(open_checkpoint(folder.path())), 2);
  EXPECT_EQ(step_of(ArchiveReader(folder / "checkpoint.previous.h5")), 1);
}

TEST(checkpoint, none_is_bad_input_and_the_message_names_the_folder) {
  const TemporaryFolder folder;
  try {
    open_checkpoint(folder.path());
    FAIL() << "there is none";
  } catch (const InputError& error) {
    EXPECT_TRUE(
        std::string(error.what()).starts_with(folder.path().string() + ": there is no checkpoint"))
        << error.what();
  }
}

TEST(checkpoint, the_extent_of_the_results_comes_back) {
  const TemporaryFolder folder;
  const ResultExtent extent{.frames = 12, .history_rows = {{"mass", 5}, {"flank", 1000}}};
  write_checkpoint(folder.path(),
                   [&](ArchiveWriter& archive) { put_extent(archive, "results", extent); });
  const auto found = get_extent(open_checkpoint(folder.path()), "results");
  EXPECT_EQ(found.frames, extent.frames);
  EXPECT_EQ(found.history_rows, extent.history_rows);
}

}  // namespace
}  // namespace pliant::test
