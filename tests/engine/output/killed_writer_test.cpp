#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "engine/output/archive/checkpoint.hpp"
#include "engine/output/results/result_file.hpp"
#include "engine/output/summary.hpp"
#include "tests/engine/output/failing_disk.hpp"
#include "tests/engine/output/sample_frames.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

// Frames of more than a chunk, so that chunks and their index blocks keep being added.
constexpr int particles = 1500;

/// Written by the child, read by the parent.
struct Shared {
  int completed;
};

Shared& shared_memory() {
  static auto* memory = static_cast<Shared*>(
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  *memory = {};
  return *memory;
}

/// Runs `work` in a separate process; returns true if SIGKILL ended it.
template <class Work>
bool is_killed(Work work) {
  const auto child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

/// A killed run leaves every frame that was reported complete, and at most one more.
void expect_completed_frames(const TemporaryFolder& folder, int completed) {
  if (completed == 0 && !std::filesystem::exists(folder / "result.h5")) return;
  int found = -1;
  ASSERT_NO_THROW(found = whole_frames(content_of(folder / "result.h5"), particles));
  EXPECT_GE(found, completed);
  EXPECT_LE(found, completed + 1);
}

// The kills are spread over all writes of the run; `stride` keeps the test short.
void kill_at_each_change(int frames, long stride) {
  auto& shared = shared_memory();
  for (long number = 0;; number += stride) {
    SCOPED_TRACE(number);
    const TemporaryFolder folder;
    shared.completed = 0;
    const bool killed = is_killed([&] {
      inject(Fault::kill, number);
      auto file = ResultFile::create(folder.path(), sample_run());
      for (int f = 0; f < frames; ++f) {
        write_frames(file, f, f + 1, particles);
        shared.completed = f + 1;
      }
      file.close();
    });
    expect_completed_frames(folder, shared.completed);
    if (!killed) {
      EXPECT_EQ(shared.completed, frames);
      EXPECT_GT(number, 20 * frames) << "a frame takes more changes than that";
      return;
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(killed_writer, leaves_all_completed_frames_whichever_write_is_its_last) {
  kill_at_each_change(12, 17);
}

// Resumes to a later end from a checkpoint that is older than the end of the file: first the file
// is cut, and the case in it replaced.
TEST(killed_writer, leaves_a_file_that_can_be_resumed_to_the_end) {
  constexpr int kept = 30, end = 36;
  const TemporaryFolder folder;
  RunDescription longer = sample_run();
  longer.resolved_case = "[time]\nend = 2.5\n";
  ResultExtent extent;
  {
    auto file = ResultFile::create(folder / "first", sample_run());
    write_frames(file, 0, kept, particles);
    extent = file.flush();
    write_frames(file, kept, end, particles);
    auto whole = ResultFile::create(folder / "whole", longer);
    write_frames(whole, 0, end, particles);
  }
  const auto whole = content_of(folder / "whole/result.h5");
  const auto resume = [&] {
    auto file = ResultFile::resume(folder / "killed", longer, extent);
    write_frames(file, kept, end, particles);
  };
  bool killed = true;
  for (long number = 0; killed; number += number < 12 ? 1 : 47) {
    SCOPED_TRACE(number);
    std::filesystem::remove_all(folder / "killed");
    std::filesystem::copy(folder / "first", folder / "killed");
    killed = is_killed([&] {
      inject(Fault::kill, number);
      resume();
    });
    ASSERT_GE(whole_frames(content_of(folder / "killed/result.h5"), particles), kept);
    resume();
    ASSERT_EQ(differences(whole, content_of(folder / "killed/result.h5")),
              std::vector<std::string>());
  }
}

// A new run starts in the folder of an earlier one.
TEST(killed_writer, never_leaves_files_of_two_runs_that_contradict_each_other) {
  constexpr int few = 20;
  const TemporaryFolder folder;
  const auto text_if_there = [](const std::filesystem::path& path) {
    return std::filesystem::exists(path) ? text_of(path) : "";
  };
  {
    auto file = ResultFile::create(folder / "earlier", sample_run());
    write_frames(file, 0, 1, few);
    for (int i = 0; i < 2; ++i)
      write_checkpoint(folder / "earlier", [](ArchiveWriter& archive) { archive.put("run", 1.0); });
    write_summary(folder / "earlier", {});
  }
  RunDescription another = sample_run();
  another.resolved_case = "[time]\nend = 2\n";
  bool killed = true, saw_both = false;
  for (long number = 0; killed; ++number) {
    SCOPED_TRACE(number);
    const auto shared = folder / "shared";
    std::filesystem::remove_all(shared);
    std::filesystem::copy(folder / "earlier", shared);
    killed = is_killed([&] {
      inject(Fault::kill, number);
      auto file = ResultFile::create(shared, another);
      write_frames(file, 0, 1, few);
    });
    const auto content = content_of(shared / "result.h5");
    const std::string& case_text = content.at("/run/case.toml").bytes;
    const std::string settings = text_if_there(shared / "case.resolved.toml");
    EXPECT_TRUE(settings.empty() || settings == case_text);
    if (case_text == sample_run().resolved_case) continue;
    saw_both = true;
    for (const char* name : {"checkpoint.h5", "checkpoint.previous.h5", "summary.json"})
      EXPECT_FALSE(std::filesystem::exists(shared / name)) << name;
  }
  EXPECT_TRUE(saw_both);
}

TEST(killed_writer, leaves_all_completed_frames_at_any_moment) {
  auto& shared = shared_memory();
  for (const auto milliseconds : {20, 45, 70, 110}) {
    const TemporaryFolder folder;
    shared.completed = 0;
    const auto child = ::fork();
    if (child == 0) {
      auto file = ResultFile::create(folder.path(), sample_run());
      for (int f = 0;; ++f) {
        write_frames(file, f, f + 1, particles);
        shared.completed = f + 1;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    expect_completed_frames(folder, shared.completed);
  }
}

}  // namespace
}  // namespace pliant::test
