#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "engine/output/archive/checkpoint.hpp"
#include "engine/output/error.hpp"
#include "engine/output/results/result_file.hpp"
#include "engine/output/summary.hpp"
#include "tests/engine/output/failing_disk.hpp"
#include "tests/engine/output/sample_frames.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

constexpr int particles = 1500;

void expect_path_and_remedy(const OutputError& error, const std::string& path) {
  const std::string message = error.what();
  EXPECT_NE(message.find(path), message.npos) << message;
  EXPECT_NE(message.find("No space left on device"), message.npos) << message;
  EXPECT_NE(message.find("free some space"), message.npos) << message;
}

/// Ends the fault at the end of the test.
struct FailingDisk {
  FailingDisk() = default;
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;
  ~FailingDisk() {
    repair();
    answer_reservations(false);
  }
};

TEST(failing_disk, a_disk_without_room_for_a_frame_is_an_error_with_path_and_remedy) {
  const FailingDisk disk;
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  write_frames(file, 0, 2, particles);
  answer_reservations(true);
  try {
    file.append(sample_frame(2, particles));
    FAIL() << "the disk was full";
  } catch (const OutputError& error) {
    expect_path_and_remedy(error, (folder / "result.h5").string());
  }
  answer_reservations(false);
  EXPECT_THROW(file.append(sample_frame(2, particles)), std::logic_error);
  file.close();
  EXPECT_EQ(whole_frames(content_of(folder / "result.h5"), particles), 2);
}

TEST(failing_disk, completed_frames_survive_whichever_write_finds_the_disk_full) {
  const FailingDisk disk;
  constexpr int frames = 4;
  bool failed = true;
  for (long number = 0; failed; number += 5) {
    SCOPED_TRACE(number);
    const TemporaryFolder folder;
    int completed = 0;
    failed = false;
    inject(Fault::disk_full, number);
    try {
      auto file = ResultFile::create(folder.path(), sample_run());
      for (; completed < frames; ++completed)
        write_frames(file, completed, completed + 1, particles);
      file.close();
    } catch (const OutputError& error) {
      failed = true;
      expect_path_and_remedy(error, folder.path().string());
    }
    repair();
    EXPECT_FALSE(std::filesystem::exists(folder / "result.h5.partial"));
    if (completed == 0 && !std::filesystem::exists(folder / "result.h5")) continue;
    // The data of the frame may be complete even if its viewer file did not fit.
    const auto found = whole_frames(content_of(folder / "result.h5"), particles);
    EXPECT_GE(found, completed);
    EXPECT_LE(found, completed + 1);
  }
}

TEST(failing_disk, the_last_checkpoint_survives_whichever_write_finds_the_disk_full) {
  const FailingDisk disk;
  const std::vector<double> first(5000, 0.5), earlier(20000, 1.5), later(30000, 2.5);
  bool failed = true;
  for (long number = 0; failed; ++number) {
    SCOPED_TRACE(number);
    const TemporaryFolder folder;
    const auto write = [&](const std::vector<double>& values) {
      write_checkpoint(folder.path(), [&](ArchiveWriter& archive) {
        archive.put("velocity/x", values);
        archive.put("step", std::int64_t{7});
      });
    };
    write(first);
    write(earlier);
    failed = false;
    inject(Fault::disk_full, number);
    try {
      write(later);
    } catch (const OutputError& error) {
      failed = true;
      expect_path_and_remedy(error, "checkpoint");
    }
    repair();
    const auto last = open_checkpoint(folder.path()).get<double>("velocity/x");
    EXPECT_EQ(last, failed ? earlier : later);
    const ArchiveReader previous(folder / "checkpoint.previous.h5");
    const auto before = previous.get<double>("velocity/x");
    // A failure while the new file is written changes neither.
    EXPECT_TRUE(before == earlier || (failed && before == first));
    if (number == 0) {
      EXPECT_EQ(before, first);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "checkpoint.h5.partial"));
  }
}

TEST(failing_disk, a_summary_is_replaced_whole_or_not_at_all) {
  const FailingDisk disk;
  const TemporaryFolder folder;
  Summary summary;
  summary.steps = 1;
  write_summary(folder.path(), summary);
  const auto earlier = text_of(folder / "summary.json");
  summary.steps = 2;
  inject(Fault::disk_full, 0);
  EXPECT_THROW(write_summary(folder.path(), summary), OutputError);
  EXPECT_EQ(text_of(folder / "summary.json"), earlier);
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json.partial"));
}

}  // namespace
}  // namespace pliant::test
