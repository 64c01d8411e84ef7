#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"

// The executable itself, interrupted as by a user.
namespace pliant::test {
namespace {

constexpr int done = 0, interrupted = 4;

/// A run of the compression case in a separate process.
class Process {
 public:
  Process(const std::filesystem::path& folder, bool resume) : id_(fork()) {
    if (id_ != 0) return;
    const std::string out = folder.string(), of = PLIANT_SOURCE_DIR "/cases/compression_linear";
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    execl(PLIANT_PROGRAM, "pliant", "run", of.c_str(), "--out", out.c_str(), "--threads", "2",
          "--set", "discretisation.spacing=1/32", "--set", "time.end=0.008", "--set",
          "output.checkpoint_every=0.001", "--set", "output.every=0.001", "--set",
          "output.surface=true", "--quiet", resume ? "--resume" : nullptr, nullptr);
    _exit(127);
  }

  void terminate() const { kill(id_, SIGTERM); }

  int exit_status() const {
    int status = 0;
    waitpid(id_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t id_;
};

TEST(resuming, an_interrupted_run_goes_on_to_the_same_file) {
  const TemporaryFolder folder;
  ASSERT_EQ(Process(folder / "whole", false).exit_status(), done);

  const Process first(folder / "parts", false);
  // The first of eight checkpoints: the run is far from its end.
  for (int ms = 0; ms < 60000 && !exists(folder / "parts" / "checkpoint.h5"); ++ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(15));  // wherever the run is then
  first.terminate();
  ASSERT_EQ(first.exit_status(), interrupted);
  ASSERT_EQ(Process(folder / "parts", true).exit_status(), done);

  const FileContent whole = content_of(folder / "whole" / "result.h5");
  EXPECT_EQ(differences(whole, content_of(folder / "parts" / "result.h5")),
            std::vector<std::string>());
  EXPECT_GT(whole.size(), 20u);
}

}  // namespace
}  // namespace pliant::test
