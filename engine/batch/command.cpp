#include "engine/batch/command.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "engine/output/error.hpp"

namespace pliant::batch {

namespace {

constexpr int no_such_program = 127;

class Pipe {
 public:
  explicit Pipe(const std::string& program) {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw OutputError::system(program, "make a pipe for its output", errno);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_writer();
    ::close(ends_[0]);
  }

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

/// Reads both pipes to their ends, in whatever order they fill.
void read_both(const Pipe& output, const Pipe& errors, CommandResult& result) {
  std::array<pollfd, 2> files = {pollfd{output.reader(), POLLIN, 0},
                                 pollfd{errors.reader(), POLLIN, 0}};
  const std::array<std::string*, 2> texts = {&result.output, &result.errors};
  std::array<char, 4096> part = {};
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    if (::poll(files.data(), files.size(), -1) < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (files[i].fd < 0 || files[i].revents == 0) continue;
      const ssize_t size = ::read(files[i].fd, part.data(), part.size());
      if (size > 0) texts[i]->append(part.data(), static_cast<std::size_t>(size));
      if (size == 0 || (size < 0 && errno != EINTR)) files[i].fd = -1;
    }
  }
}

}  // namespace

CommandResult run_command(std::vector<std::string> command) {
  Pipe output(command[0]), errors(command[0]);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output.writer(), 1);
  posix_spawn_file_actions_adddup2(&actions, errors.writer(), 2);
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& text : command) arguments.push_back(text.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  CommandResult result;
  if (error != 0) {
    result.status = no_such_program;
    return result;
  }
  output.close_writer();
  errors.close_writer();
  read_both(output, errors, result);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace pliant::batch
